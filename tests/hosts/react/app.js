// What server and browser render alike, as frameworks with server rendering do. React gives an
// element that the server wrote no properties and hears no events of it: what is asked of it goes
// by a reference.

import { createElement, useEffect, useRef, useState } from 'react';
import 'slicecast';
import 'slicecast/scenes/first-walk';

export default function App() {
  const [title, setTitle] = useState('');
  const caster = useRef(null);
  useEffect(() => {
    caster.current.whenReady().then(({ title: found }) => setTitle(found));
  }, []);
  return createElement(
    'main',
    null,
    createElement('h1', null, title),
    createElement('ray-caster', {
      ref: caster,
      scene: 'first-walk',
      size: '320x200',
      controls: true,
      label: 'The first walk',
    }),
  );
}
