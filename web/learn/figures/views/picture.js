// The engine's picture, with marks over it.

import { clamp } from '../geometry.js';
import { box, fixed, group, knob, path } from '../markup.js';

const kStrip = 22; // pixels of the window beside the picture's edge where a handle sits

export function picture({
  title,
  share = 1,
  handles = ['column'],
  mark = 'slice',
  over,
  walk = false,
  options = null,
  alt,
  ...others
} = {}) {
  return {
    kind: 'picture',
    title,
    share,
    walk,
    options,
    alt,
    mark,
    ...others,
    markup: (now) => marks(now, mark) + (over?.(now) ?? ''),
    knobs: (now, { width, height }) =>
      pictureHandles(handles, now, width, height)
        .map(({ x, y, kind, axis }) => knob(x, y, kind, 10, axis))
        .join(''),
    handles: (now, { width, height }) => pictureHandles(handles, now, width, height),
    point(now, { x, y }, { width, height }) {
      if (mark === 'none') return null;
      const column = Math.floor((x * now.width) / width);
      const row = Math.floor((y * now.height) / height);
      return mark === 'row'
        ? { row }
        : mark === 'slice' && !handles.includes('row')
          ? { column }
          : { column, row };
    },
  };
}

// Marks in the picture's pixels.
export function marks({ width, height, column, row }, mark) {
  if (mark === 'slice')
    return (
      box(column - 1.5, 0, 4, height, 'class="fig-mark-edge"') +
      box(column, 0, 1, height, 'class="fig-mark-line"')
    );
  if (mark === 'row')
    return (
      box(0, row - 1.5, width, 4, 'class="fig-mark-edge"') +
      box(0, row, width, 1, 'class="fig-mark-line"')
    );
  if (mark !== 'pixel') return '';
  return group('', [
    box(column - 1, 0, 3, height, 'class="fig-mark-edge faint"'),
    box(column, 0, 1, height, 'class="fig-mark-line faint"'),
    box(0, row - 1, width, 3, 'class="fig-mark-edge faint"'),
    box(0, row, width, 1, 'class="fig-mark-line faint"'),
    path(`M${column - 6} ${row - 6}h13v13h-13Z`, 'class="fig-pixel edge"'),
    path(`M${column - 6} ${row - 6}h13v13h-13Z`, 'class="fig-pixel"'),
  ]);
}

function pictureHandles(names, now, width, height) {
  const { state, eye } = now;
  const all = {
    column: () => ({
      id: 'column',
      label: 'Slice',
      kind: 'ray',
      axis: 'x',
      x: ((now.column + 0.5) * width) / now.width,
      y: height - kStrip,
      value: now.column,
      least: 0,
      greatest: now.width - 1,
      says: `column ${now.column} of ${now.width}`,
      drag: ({ x }) => ({ column: Math.floor((x * now.width) / width) }),
      keys: (right) => ({ column: state.column + right }),
    }),
    row: () => ({
      id: 'row',
      label: 'Row',
      kind: 'ray',
      axis: 'y',
      x: width - kStrip,
      y: ((now.row + 0.5) * height) / now.height,
      value: now.row,
      least: 0,
      greatest: now.height - 1,
      says: `row ${now.row} of ${now.height}`,
      drag: ({ y }) => ({ row: Math.floor((y * now.height) / height) }),
      keys: (right, down) => ({ row: state.row + (down || right) }),
    }),
    // To the right turns to the right, as with the arrow keys.
    turn: () => ({
      id: 'turn',
      label: 'Turn',
      kind: 'turn',
      axis: 'x',
      x: width / 2,
      y: kStrip,
      value: Math.round(eye.heading),
      least: 0,
      greatest: 360,
      says: `${fixed(eye.heading, 0)} degrees, ${now.compass(eye.heading)}`,
      drag: ({ x }, _, start) => ({
        eye: { heading: start.state.eye.heading + (now.slice.fov * (x - start.point.x)) / width },
      }),
      keys: (right) => ({ eye: { heading: state.eye.heading + right } }),
    }),
    look: () => ({
      id: 'look',
      label: 'Look up and down',
      kind: 'turn',
      axis: 'y',
      x: kStrip,
      y: clamp(height / 2 + eye.look * height, kStrip, height - kStrip),
      value: Number(eye.look.toFixed(2)),
      least: -4,
      greatest: 4,
      says: `${fixed(eye.look)} picture heights up`,
      drag: ({ y }) => ({ eye: { look: clamp((y - height / 2) / height, -4, 4) } }),
      keys: (right, down) => ({
        eye: { look: Math.round((state.eye.look + 0.02 * (down || right)) * 1e4) / 1e4 },
      }),
    }),
  };
  return names.filter((name) => Object.hasOwn(all, name)).map((name) => all[name]());
}

// A panel's width for a picture: whole screen pixels for each of its own if that fills the panel
// well, as <ray-caster> lays it out.
export function pictureWidth([width, height], available, ratio = 1, tallest = Infinity) {
  const fits = Math.min((available * ratio) / width, (tallest * ratio) / height);
  const whole = Math.floor(fits);
  return ((whole >= 1 && whole >= fits * 0.8 ? whole : fits) * width) / ratio;
}
