// Adds the page's optional parts: the opening, hints, messages about keys, the Lab with photo mode,
// benchmark, recordings and pixels explained, and the key editor.
//
//     const { opening, replayBar } = addPageParts(caster, { settings, address, dialogs, status });

import { BenchmarkDialog } from './benchmark-dialog.js';
import { ExplainPixel } from './explain-pixel.js';
import { keepPanelsClear } from './free-area.js';
import { GameDisplay } from './game-display.js';
import { Hints } from './hints.js';
import { KeyEditor } from './key-editor.js';
import { listenForEffects } from './key-effects.js';
import { Lab } from './lab.js';
import { Opening } from './opening.js';
import { Photo } from './photo.js';
import { ReplayBar } from './replay-bar.js';
import { SliceDialog } from './slice-dialog.js';
import { Toast } from './toast.js';

const find = (id) => document.getElementById(id);

export function addPageParts(caster, { settings, address, dialogs, status }) {
  const toast = new Toast(find('toast'));
  listenForEffects(caster, toast);
  keepPanelsClear(caster);
  new Hints(caster, find('hint'));
  new GameDisplay(find('game'), caster, () => address.reference);
  new KeyEditor(find('keys'), caster, () => dialogs.showKeys());

  const flight = () => status.scenes.find(({ file }) => file === address.reference)?.flight;
  const benchmark = new BenchmarkDialog(find('benchmark'), caster, flight);
  dialogs.opens('benchmark', () => benchmark.open());
  const slice = new SliceDialog(find('slice'), caster);
  dialogs.opens('slice', () => slice.open());
  const photo = new Photo(find('photo'), caster, {
    nameOf: () => (address.reference ?? 'picture').replace(/\.json$/, ''),
  });
  const replayBar = new ReplayBar(find('replay'), caster, {
    address,
    say: (text) => toast.show(text),
    fail: (error) => status.fail(error),
  });
  const explain = new ExplainPixel(find('explain'), find('explain-cover'), caster);
  const lab = new Lab(find('lab'), caster, {
    settings,
    photo: () => photo.begin(),
    benchmark: () => dialogs.open('benchmark'),
    record: (how) => replayBar.record(how),
    replay: () => find('files').click(),
    explain: () => explain.begin(),
  });
  find('open-lab').addEventListener('click', () => {
    explain.end();
    lab.toggle();
  });
  return { opening: new Opening(caster), replayBar };
}
