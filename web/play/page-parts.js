// Adds the page's optional parts: the opening, hints, messages about keys, the Lab with photo mode
// and benchmark, and the key editor.
//
//     const { opening, toast } = addPageParts(caster, { settings, address, dialogs, status });

import { BenchmarkDialog } from './benchmark-dialog.js';
import { GameDisplay } from './game-display.js';
import { Hints } from './hints.js';
import { KeyEditor } from './key-editor.js';
import { listenForEffects } from './key-effects.js';
import { Lab } from './lab.js';
import { Opening } from './opening.js';
import { Photo } from './photo.js';
import { Toast } from './toast.js';

const find = (id) => document.getElementById(id);

export function addPageParts(caster, { settings, address, dialogs, status }) {
  const toast = new Toast(find('toast'));
  listenForEffects(caster, toast);
  new Hints(caster, find('hint'));
  new GameDisplay(find('game'), caster, () => address.reference);
  new KeyEditor(find('keys'), caster, () => dialogs.showKeys());

  const flight = () => status.scenes.find(({ file }) => file === address.reference)?.flight;
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
  return { opening: new Opening(caster), toast };
}
