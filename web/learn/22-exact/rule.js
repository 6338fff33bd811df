// Three rules for a corner, side by side: the right one, `<=` for `<`, and both borders at once.

import { box, button, divider, drawing, escape, fixed, text } from '../figures/kit.js';
import { drawWith, byHandWorld } from '../by-hand.js';
import { draw as exact } from '../by-hand/chapter-22.js';
import { draw as wrong } from '../by-hand/less-or-equal.js';
import { differing, drawnBy } from './pictures.js';
import { blockOn, kRules } from './ties.js';

const kBeside = 5; // columns on either side of the middle

const columnsOf = (now) =>
  now.kept('columns', () => differing(drawnBy(exact, now), drawnBy(wrong, now), now.width).columns);

// What the middle columns see, enlarged: a row of colours for each rule.
function enlarged(now, { width }) {
  const middle = now.width >> 1;
  const count = 2 * kBeside + 1;
  const wide = width / count;
  const columns = Array.from({ length: count }, (_, index) => middle - kBeside + index);
  const traces = now.source.trace(columns);
  return Object.entries(kRules)
    .map(([name, { title }], row) => {
      const top = row * kRow;
      const bars = traces.map((slice, index) => {
        const { colour } = blockOn(slice, now.cells[0], now.blueprints, name);
        return box(index * wide, top + 22, wide, kRow - 34, `fill="${colour}"`);
      });
      return text(0, top + 15, title) + bars.join('');
    })
    .join('');
}
const kRow = 84;

export default {
  world: byHandWorld,
  scene: 'corner.json',
  view: '5,5,0.5,135',
  size: [481, 300],
  options: { fov: 60 },
  state: { split: 0.3 },
  controls: [
    button({ label: 'South-east', change: () => ({ eye: { heading: 45 } }) }),
    button({ label: 'South-west', change: () => ({ eye: { heading: 135 } }) }),
    button({ label: 'North-west', change: () => ({ eye: { heading: 225 } }) }),
    button({ label: 'A little to the side', change: () => ({ eye: { heading: 140 } }) }),
  ],
  rows: [
    [
      divider({
        left: { title: 'Your rule', draw: drawWith(exact) },
        right: { title: '<= instead of <', draw: drawWith(wrong) },
      }),
    ],
    [
      drawing({
        title: 'The eleven columns in the middle, enlarged',
        label: () => 'The colours that the columns in the middle show, by each of the three rules',
        height: kRow * 3,
        markup: enlarged,
      }),
    ],
  ],
  numbers: {
    columns: (now) => String(columnsOf(now).length),
    column: (now) => String(columnsOf(now)[0] ?? '–'),
    width: (now) => String(now.width),
    share: (now) => fixed(100 * (1 - columnsOf(now).length / now.width), 1),
  },
  says: (now) => {
    const { length } = columnsOf(now);
    return length === 0
      ? `With ${escape('<=')} no column differs: nothing here meets a corner, or both rules agree.`
      : `With ${escape('<=')} ${length === 1 ? 'one column differs' : `${length} columns differ`} of ${now.width}: column ${columnsOf(now).join(', ')}.`;
  },
};
