// The map from above: tiles, the eye, the ray of the slice with the tiles that its walk has
// entered, and the crossings of borders.

import { clamp, crossing, distanceOf } from '../geometry.js';
import {
  at,
  box,
  dot,
  fixed,
  group,
  kCharacter,
  knob,
  line,
  mark,
  path,
  polygon,
  text,
} from '../markup.js';
import { drawing } from './own.js';

const kReach = 64; // tiles: of lines that end outside the drawing
const kHeadingReach = 64; // pixels from the eye to the handle that turns it
const kTallest = 520; // pixels
const kRim = 10; // pixels around the tiles

export function mapView({
  levels = null,
  map = null,
  window = null,
  handles = ['eye', 'heading'],
  ray = true,
  lit = true,
  order = true,
  marks = true,
  depths = true,
  fov = true,
  objects = true,
  heights = false,
  column = false,
  tallest = kTallest,
  paint = false,
  level = 0,
  blocks = null,
  over,
  title,
  ...others
} = {}) {
  const look = {
    levels,
    map,
    window,
    ray,
    lit,
    order,
    marks,
    depths,
    fov,
    objects,
    heights,
    tallest,
    over,
  };
  const view = drawing({
    title,
    ...others,
    label: others.label ?? ((now) => says(now, look)),
    height: (width, now) => frame(now, look, width).height,
    markup(now, size) {
      const it = frame(now, look, size.width);
      return (
        draw(now, look, it, `${size.id}-clip`) +
        (paint ? cursor(now, it) : '') +
        knobs(now, handles, look, it)
      );
    },
    handles: (now, size) => mapHandles(now, handles, look, frame(now, look, size.width)),
    click: column
      ? (point, now, size) => columnAt(point, now, frame(now, look, size.width))
      : undefined,
  });
  return paint ? { ...view, kind: 'paint', paint: painting({ map, level, blocks, look }) } : view;
}

// ---- Where tiles are in the drawing

function frame(now, { map, window, tallest }, width) {
  const itsMap = now.map(map ?? now.eye.map);
  const [left, top, wide, deep] = window ?? [0, 0, itsMap.width, itsMap.depth];
  const unit = Math.min((width - 2 * kRim) / wide, (tallest - 2 * kRim) / deep);
  const origin = [(width - unit * wide) / 2, kRim];
  const place = (x, y) => [origin[0] + unit * (x - left), origin[1] + unit * (y - top)];
  const back = ([px, py]) => [left + (px - origin[0]) / unit, top + (py - origin[1]) / unit];
  Object.assign(place, { unit, back });
  return {
    map: itsMap,
    left,
    top,
    wide,
    deep,
    unit,
    place,
    back,
    width,
    height: unit * deep + 2 * kRim,
  };
}

const inside = ({ left, top, wide, deep }, x, y) =>
  x >= left && y >= top && x < left + wide && y < top + deep;

// ---- The drawing

function draw(now, look, it, id) {
  const { place, unit } = it;
  const [x, y] = place(it.left, it.top);
  return (
    `<clipPath id="${id}">${box(x - 4, y - 4, unit * it.wide + 8, unit * it.deep + 8)}</clipPath>` +
    box(x, y, unit * it.wide, unit * it.deep, 'class="fig-ground"') +
    group(`clip-path="url(#${id})"`, [
      blocksOf(now, look, it),
      look.lit ? litTiles(now, look, it) : '',
      grid(it),
      look.objects ? objectsOf(it) : '',
      portalsOf(it),
      look.fov ? fovOf(now, it) : '',
      look.ray ? rayOfSlice(now, look, it) : '',
    ]) +
    (look.ray && look.marks ? crossings(now, look, it) : '') +
    (look.over?.(
      now,
      Object.assign((px, py) => place(px, py), { unit }),
    ) ?? '')
  );
}

function blocksOf(now, { levels, heights }, it) {
  const { map, place, unit } = it;
  const parts = [];
  const shown = levels ?? map.cells.map((_, index) => index);
  for (let y = it.top; y < it.top + it.deep; ++y)
    for (let x = it.left; x < it.left + it.wide; ++x) {
      const stack = shown
        .map((level) => ({
          level,
          block: map.blueprints.get([...(map.cells[level]?.[y] ?? '')][x]),
        }))
        .filter(({ block }) => block !== undefined);
      if (stack.length === 0) continue;
      const [px, py] = place(x, y);
      const first = levels === null ? stack.at(-1) : stack[0];
      const fill = colourOf(first.block);
      const kind = first.block.seeThrough
        ? ' see-through'
        : first.level + first.block.bottom > 0 && levels === null && stack.length === 1
          ? ' floating'
          : '';
      parts.push(
        box(
          px,
          py,
          unit,
          unit,
          `class="fig-block${kind}"${fill === null ? '' : ` fill="${fill}"`}`,
        ),
      );
      if (levels !== null)
        stack.slice(1).forEach((_, index) => {
          const gap = Math.min(4 + 4 * index, unit / 3);
          parts.push(box(px + gap, py + gap, unit - 2 * gap, unit - 2 * gap, 'class="fig-upper"'));
        });
      if (heights && unit >= 24) {
        const top = stack.at(-1);
        parts.push(
          text(
            px + unit - 4,
            py + unit - 5,
            String(Number((top.level + top.block.top).toFixed(unit < 34 ? 1 : 2))),
            'class="on-block" text-anchor="end"',
          ),
        );
      }
    }
  return parts.join('');
}

export function colourOf({ faces }) {
  return faces.south.colour ?? faces.top.colour ?? faces.north.colour;
}

function grid({ place, left, top, wide, deep }) {
  let d = '';
  for (let x = left; x <= left + wide; ++x)
    d += `M${place(x, top).map(at).join(' ')}V${at(place(x, top + deep)[1])}`;
  for (let y = top; y <= top + deep; ++y)
    d += `M${place(left, y).map(at).join(' ')}H${at(place(left + wide, y)[0])}`;
  return path(d, 'class="fig-grid"');
}

// The walk's tiles that lie in the drawing, with their place in the walk.
function tilesIn(now, it) {
  return now.tiles
    .map((tile, index) => ({ ...tile, index }))
    .filter(({ map, tile: [x, y] }) => map === it.map.name && inside(it, x, y));
}

function litTiles(now, { order }, it) {
  const { place, unit } = it;
  const count = now.slice.walk.length;
  const current = now.step?.of === 'walk' ? now.step.index : -1;
  const isNumbered = order && unit >= 20;
  return tilesIn(now, it)
    .map(({ tile: [x, y], index }) => {
      const [px, py] = place(x, y);
      const opacity = at(0.95 - (0.35 * index) / count);
      return (
        box(px, py, unit, unit, `class="fig-lit" opacity="${opacity}"`) +
        (index === current ? box(px + 1, py + 1, unit - 2, unit - 2, 'class="fig-now"') : '') +
        (isNumbered ? numberOf(now, it, index) : '')
      );
    })
    .join('');
}

// A tile's number stands in the corner that is farthest from the ray.
function numberPlace(now, { place, unit }, index) {
  const {
    tile: [x, y],
    portals,
  } = now.slice.walk[index];
  const eye = now.eyes[portals] ?? now.eyes[0];
  const [px, py] = place(x, y);
  const half = (String(index + 1).length * kCharacter) / 2 + 3;
  const away = (cornerX, cornerY) =>
    Math.abs((cornerX - eye.x) * eye.ray[1] - (cornerY - eye.y) * eye.ray[0]);
  const corners = [0, 1].flatMap((right) =>
    [0, 1].map((down) => ({
      right,
      down,
      far: away(x + 0.2 + 0.6 * right, y + 0.25 + 0.5 * down),
    })),
  );
  const { right, down } = corners.sort((a, b) => b.far - a.far)[0];
  return [px + (right ? unit - half : half), py + (down ? unit - 9 : 9)];
}

function numberOf(now, it, index) {
  const [x, y] = numberPlace(now, it, index);
  return text(x, y + 4.5, String(index + 1), 'class="fig-order" text-anchor="middle"');
}

// The ray as lines between depths, each in the map where it is there.
function rayOfSlice(now, { lit }, it) {
  const { slice, eyes, tiles } = now;
  const parts = [];
  const end = endOf(now);
  const pointAt = (eye, depth) => it.place(eye.x + depth * eye.ray[0], eye.y + depth * eye.ray[1]);
  eyes.forEach((eye, portals) => {
    if (eye.map !== it.map.name) return;
    const from =
      portals === 0 ? 0 : slice.portals.find((portal) => portal.portals === portals - 1).depth;
    const next = slice.portals.find((portal) => portal.portals === portals);
    const to = next?.depth ?? kReach;
    parts.push(
      line(...pointAt(eye, from), ...pointAt(eye, Math.min(to, kReach)), 'class="fig-ray-ahead"'),
    );
    if (end > from || portals === 0)
      parts.push(
        line(
          ...pointAt(eye, from),
          ...pointAt(eye, Math.max(from, Math.min(to, end))),
          'class="fig-ray"',
        ),
      );
  });
  if (!lit && tiles.length === 0) return '';
  return parts.join('');
}

// How far the walk is shown: to where it enters the last tile shown, or to the first block that
// closes all rows.
function endOf({ tiles, slice }) {
  const last = tiles.at(-1)?.depth ?? 0;
  return tiles.length < slice.walk.length ? last : Math.max(last, 0);
}

function crossings(now, { depths, order, lit }, it) {
  const { slice, eyes } = now;
  const parts = [];
  const labels = [];
  const size = clamp(it.unit / 5, 4, 6.5);
  const current = now.step?.of === 'walk' ? now.step.index : -1;
  for (const { index, axis } of tilesIn(now, it)) {
    if (axis === null) continue;
    const { x, y, depth } = crossing(slice, index, eyes);
    const [px, py] = it.place(x, y);
    parts.push(mark(px, py, axis, index === current ? size * 1.4 : size));
    labels.push({ px, py, index, depth, ray: eyes[slice.walk[index].portals]?.ray ?? slice.ray });
  }
  if (depths) {
    const numbers =
      order && lit && it.unit >= 20
        ? tilesIn(now, it).map(({ index }) => numberPlace(now, it, index))
        : [];
    const taken = numbers.map(([x, y]) => [x - 8, y - 7, x + 8, y + 7]);
    if (now.eye.map === it.map.name) {
      const [x, y] = it.place(now.eye.x, now.eye.y);
      const [toX, toY] = placesOf(now, it).heading;
      taken.push([x - 13, y - 13, x + 13, y + 13], [toX - 10, toY - 10, toX + 10, toY + 10]);
    }
    parts.push(depthLabels(labels, taken, it));
  }
  return parts.join('');
}

// Depths beside the crossings, left out where they would touch each other; the last one always
// stands.
function depthLabels(labels, others, { width, height }) {
  const taken = [...others, ...labels.map(({ px, py }) => [px - 6, py - 6, px + 6, py + 6])];
  const parts = [];
  for (const { px, py, depth, ray } of labels.reverse()) {
    const written = fixed(depth);
    const wide = written.length * kCharacter;
    const length = Math.hypot(...ray);
    // To either side of the ray.
    for (const side of [1, -1]) {
      const away = [(-side * ray[1]) / length, (side * ray[0]) / length];
      const x = clamp(px + away[0] * (wide / 2 + 12), wide / 2 + 2, width - wide / 2 - 2);
      const y = clamp(py + away[1] * 19, 12, height - 12);
      const area = [x - wide / 2 - 2, y - 9, x + wide / 2 + 2, y + 9];
      if (taken.some((other) => overlap(area, other))) continue;
      taken.push(area);
      parts.push(text(x, y + 4.5, written, 'class="fig-depth halo" text-anchor="middle"'));
      break;
    }
  }
  return parts.join('');
}

const overlap = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];

function fovOf(now, it) {
  const { eye, slice } = now;
  if (eye.map !== it.map.name) return '';
  const slope = Math.tan((slice.fov * Math.PI) / 360);
  const forward = forwardOf(eye);
  const edges = [-slope, slope].map((k) =>
    it.place(
      eye.x + kReach * (forward[0] - k * forward[1]),
      eye.y + kReach * (forward[1] + k * forward[0]),
    ),
  );
  const from = it.place(eye.x, eye.y);
  return (
    polygon([from, ...edges], 'class="fig-fov"') +
    edges.map((edge) => line(...from, ...edge, 'class="fig-fov-edge"')).join('')
  );
}

function objectsOf({ map, place, unit, ...rest }) {
  return map.objects
    .filter(({ x, y }) => inside({ ...rest }, x, y))
    .map(({ x, y }) => dot(...place(x, y), Math.max(4, unit * 0.2), 'class="fig-object"'))
    .join('');
}

const kFaces = { north: [0, 0, 1, 0], east: [1, 0, 1, 1], south: [0, 1, 1, 1], west: [0, 0, 0, 1] };

function portalsOf({ map, place, unit, ...rest }) {
  const ends = map.portals.flatMap((portal) => [
    portal,
    ...((portal.to.map ?? map.name) === map.name ? [{ ...portal.to, isExit: true }] : []),
  ]);
  return ends
    .filter(({ x, y }) => inside({ ...rest }, x, y))
    .map(({ x, y, face, isExit }) => {
      const edge = kFaces[face];
      if (edge) {
        const [fromX, fromY, toX, toY] = edge;
        return line(
          ...place(x + fromX, y + fromY),
          ...place(x + toX, y + toY),
          'class="fig-portal face"',
        );
      }
      const [px, py] = place(x, y);
      return box(px + 2, py + 2, unit - 4, unit - 4, `class="fig-portal${isExit ? ' exit' : ''}"`);
    })
    .join('');
}

function says(now, { map }) {
  const { tiles, eye, slice } = now;
  const where = `Map ${map ?? eye.map} from above. The eye is at ${fixed(eye.x)}, ${fixed(eye.y)}`;
  return `${where}; the ray of column ${slice.column} passes ${tiles.length} tiles.`;
}

function forwardOf({ heading }) {
  const angle = (heading * Math.PI) / 180;
  return [Math.cos(angle), Math.sin(angle)];
}

// ---- Handles

function placesOf(now, it) {
  const { eye } = now;
  const [x, y] = it.place(eye.x, eye.y);
  const forward = forwardOf(eye);
  // The handle stays in the drawing even if the eye looks out of it.
  const room = (from, step, least, most) =>
    step > 0 ? (most - from) / step : step < 0 ? (least - from) / step : Infinity;
  const reach = Math.max(
    26,
    Math.min(
      kHeadingReach,
      room(x, forward[0], 12, it.width - 12),
      room(y, forward[1], 12, it.height - 12),
    ),
  );
  return { eye: [x, y], heading: [x + reach * forward[0], y + reach * forward[1]], forward };
}

function knobs(now, handles, look, it) {
  const { eye } = now;
  if (eye.map !== it.map.name) return '';
  const places = placesOf(now, it);
  const [x, y] = places.eye;
  const [dx, dy] = places.forward;
  const isTurned = handles.includes('heading');
  return (
    (isTurned
      ? line(x, y, ...places.heading, 'class="fig-heading"') + knob(...places.heading, 'turn', 8)
      : '') +
    (handles.includes('eye') ? knob(x, y, 'eye') : dot(x, y, 8, 'class="fig-eye"')) +
    line(x + 3 * dx, y + 3 * dy, x + 10 * dx, y + 10 * dy, 'class="fig-eye-ahead"')
  );
}

function mapHandles(now, names, look, it) {
  const { eye, state } = now;
  if (eye.map !== it.map.name) return [];
  const places = placesOf(now, it);
  const all = {
    eye: () => ({
      id: 'eye',
      label: 'Eye',
      x: places.eye[0],
      y: places.eye[1],
      value: Number(eye.x.toFixed(2)),
      least: 0,
      greatest: it.map.width,
      says: `x ${fixed(eye.x)}, y ${fixed(eye.y)}`,
      drag({ x, y }) {
        const [toX, toY] = it.back([x, y]);
        return {
          eye: {
            x: clamp(Math.round(toX * 100) / 100, it.left + 0.02, it.left + it.wide - 0.02),
            y: clamp(Math.round(toY * 100) / 100, it.top + 0.02, it.top + it.deep - 0.02),
          },
        };
      },
      keys: (right, down) => ({
        eye: {
          x: clamp(Math.round(state.eye.x * 1e4 + right * 500) / 1e4, it.left, it.left + it.wide),
          y: clamp(Math.round(state.eye.y * 1e4 + down * 500) / 1e4, it.top, it.top + it.deep),
        },
      }),
    }),
    heading: () => ({
      id: 'heading',
      label: 'Heading',
      axis: 'x',
      x: places.heading[0],
      y: places.heading[1],
      value: Math.round(eye.heading),
      least: 0,
      greatest: 360,
      says: `${fixed(eye.heading, 0)} degrees, ${now.compass(eye.heading)}`,
      drag: ({ x, y }) => ({
        eye: {
          heading:
            Math.round((Math.atan2(y - places.eye[1], x - places.eye[0]) * 1800) / Math.PI) / 10,
        },
      }),
      keys: (right, down) => ({ eye: { heading: state.eye.heading + (right || down) } }),
    }),
  };
  return names.filter((name) => Object.hasOwn(all, name)).map((name) => all[name]());
}

// The column that looks at a point, or null behind the eye.
function columnAt({ x, y }, now, it) {
  const { eye, slice, width } = now;
  const [toX, toY] = it.back([x, y]);
  const [forwardX, forwardY] = forwardOf(eye);
  const [dx, dy] = [toX - eye.x, toY - eye.y];
  const ahead = dx * forwardX + dy * forwardY;
  if (ahead <= 0) return null;
  const slope = (dy * forwardX - dx * forwardY) / ahead;
  return { column: Math.round(slope * distanceOf(slice.fov, width) + width / 2 - 0.5) };
}

// ---- Painting

// What the page needs to paint: the cell at a point, the cursor, and the change of a stroke.
function painting({ map, level, blocks, look }) {
  return {
    blocksOf(now) {
      const { blueprints } = now.map(map ?? now.eye.map);
      const fixedOnes = [...blueprints.values()].filter(({ moves, gate }) => !moves && !gate);
      const signs = blocks ?? [...fixedOnes.map(({ character }) => character), '.'];
      return signs.map((character) => ({
        character,
        name: character === '.' ? 'empty' : (blueprints.get(character)?.name ?? character),
        colour: blueprints.has(character) ? colourOf(blueprints.get(character)) : null,
      }));
    },
    cellAt({ x, y }, now, { width }) {
      const it = frame(now, look, width);
      const cell = it.back([x, y]).map(Math.floor);
      return inside(it, ...cell) ? cell : null;
    },
    startCell(now, { width }) {
      const it = frame(now, look, width);
      return [it.left + (it.wide >> 1), it.top + (it.deep >> 1)];
    },
    middleOf([x, y], now, { width }) {
      const it = frame(now, look, width);
      const [px, py] = it.place(x + 0.5, y + 0.5);
      return { x: px, y: py };
    },
    within([x, y], now, { width }) {
      const it = frame(now, look, width);
      return [clamp(x, it.left, it.left + it.wide - 1), clamp(y, it.top, it.top + it.deep - 1)];
    },
    characterAt: ([x, y], now) =>
      [...(now.map(map ?? now.eye.map).cells[level]?.[y] ?? '')][x] ?? '.',
    // The edits after painting a cell: an earlier one of the same cell is replaced.
    edited([x, y], character, now) {
      const name = map ?? now.eye.map;
      const others = now.state.edits.filter(
        ([itsMap, itsLevel, itsX, itsY]) =>
          itsMap !== name || itsLevel !== level || itsX !== x || itsY !== y,
      );
      return { edits: [...others, [name, level, x, y, character]] };
    },
  };
}

// The cell cursor.
function cursor(now, it) {
  const [x, y] = now.state.cell ?? [it.left + (it.wide >> 1), it.top + (it.deep >> 1)];
  const [px, py] = it.place(x, y);
  return box(px + 1.5, py + 1.5, it.unit - 3, it.unit - 3, 'class="fig-cursor"');
}
