import { createElement, useState } from 'react';
import { createRoot, hydrateRoot } from 'react-dom/client';
import walk from 'slicecast/scenes/first-walk';
import App from './app.js';

// What only the browser renders takes objects and hears events.
function Another() {
  const [title, setTitle] = useState('');
  return createElement(
    'section',
    null,
    createElement('h2', null, title),
    createElement('ray-caster', {
      scene: walk,
      size: '320x200',
      loading: 'eager',
      onready: ({ detail }) => setTitle(detail.title),
    }),
  );
}

hydrateRoot(document.getElementById('root'), createElement(App));
createRoot(document.getElementById('more')).render(createElement(Another));
