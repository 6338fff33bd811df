// What the page has around the game: the opening, hints and echoes, the Lab with photo mode and
// benchmark, keys that can be changed.
//
//     const { opening } = putAround(caster, { settings, address, dialogs, face });

import { BenchmarkDialog } from './benchmark-dialog.js';
import { listenForEffects } from './echo.js';
import { Hints } from './hints.js';
import { KeyEditor } from './key-editor.js';
import { Lab } from './lab.js';
import { Opening } from './opening.js';
import { Photo } from './photo.js';
import { Toast } from './toast.js';

const find = (id) => document.getElementById(id);

export function putAround(caster, { settings, address, dialogs, face }) {
  listenForEffects(caster, new Toast(find('toast')));
  new Hints(caster, find('hint'));
  new KeyEditor(find('keys'), caster, () => dialogs.showKeys());

  const flight = () => face.scenes.find(({ file }) => file === address.reference)?.flight;
  const benchmark = new BenchmarkDialog(find('benchmark'), caster, flight);
  dialogs.opens('benchmark', () => benchmark.open());
  const photo = new Photo(find('photo'), caster, {
    write: (name, value) => lab.write(name, value),
    nameOf: () => (address.reference ?? 'picture').replace(/\.json$/, ''),
  });
  const lab = new Lab(find('lab'), caster, {
    settings,
    photo: () => photo.begin(),
    benchmark: () => dialogs.open('benchmark'),
  });
  find('open-lab').addEventListener('click', () => lab.toggle());
  return { opening: new Opening(caster) };
}
