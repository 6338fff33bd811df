// The slice from the side: depth to the right, heights up.

import { clamp, eyesOf, placeOf, slopeEnds, slopeOf, ticks } from '../geometry.js';
import { box, dot, fixed, group, knob, line, mark, polygon, text } from '../markup.js';
import { drawing } from './own.js';

const kLeft = 52;
const kTop = 12;
const kFoot = 40; // pixels below the lowest height, for depths
const kPlane = 64; // pixels from the eye to the picture plane, at most

export function sideView({
  handles = ['eye'],
  runs = true,
  sights = true,
  plane = true,
  edges = false,
  mirror = true,
  depth = 4,
  height = 1.2,
  tall = 300,
  over,
  title,
  ...others
} = {}) {
  const look = { runs, sights, plane, edges, mirror, depth, height, tall, over };
  return drawing({
    title,
    height: tall,
    ...others,
    label:
      others.label ??
      ((now) =>
        `The slice from the side: the eye at height ${fixed(now.eye.z)}, and ${now.slice.hits.length} blocks.`),
    markup: (now, size) => draw(now, look, size, handles),
    handles: (now, size) => sideHandles(now, handles, frame(now, look, size)),
  });
}

// ---- Where depths and heights are in the drawing

function frame(now, { depth, height, mirror, tall }, { width }) {
  const { slice } = now;
  const { eye, hits, objects } = slice;
  const ceiling = now.map(now.eye.map).ceiling?.height ?? 0;
  const risen = (of, z) => z - ((eyesOf(slice)[of.portals]?.z ?? eye.z) - eye.z);
  const ends = hits.map((hit) => Math.min(hit.backDepth ?? hit.depth + 1, hit.depth + 2));
  const farthest = Math.max(depth, ...ends, ...objects.map((object) => object.depth + 0.5)) * 1.03;
  const highest =
    Math.max(
      height,
      eye.z + 0.4,
      ceiling + 0.1,
      ...hits.map((hit) => risen(hit, hit.top)),
      ...objects.map((object) => risen(object, object.top)),
    ) * 1.06;
  const mirrored = mirror && slice.reflection !== null ? mirroredEye(now) : null;
  const lowest = Math.min(
    0,
    mirrored === null ? 0 : mirrored - 0.2,
    ...hits.map((hit) => risen(hit, hit.bottom)),
  );
  const floor = tall - kFoot;
  const unitX = (width - kLeft - 10) / farthest;
  const unitZ = (floor - kTop) / (highest - lowest * 1.12);
  const zero = kTop + unitZ * highest;
  const place = (t, z) => [kLeft + unitX * t, zero - unitZ * z];
  const back = ({ x, y }) => [(x - kLeft) / unitX, (zero - y) / unitZ];
  return {
    width,
    farthest,
    highest,
    lowest,
    unitX,
    unitZ,
    place,
    back,
    risen,
    mirrored,
    ceiling,
    bottom: floor,
    plane: Math.min(kPlane, width / 9),
  };
}

function mirroredEye({ slice }) {
  const height = slice.mirrors[0]?.height;
  return height === undefined ? null : 2 * height - slice.eye.z;
}

// ---- The drawing

function draw(now, look, size, handles) {
  const it = frame(now, look, size);
  const { place, width } = it;
  const id = `${size.id}-clip`;
  const [, ground] = place(0, 0);
  return (
    `<clipPath id="${id}">${box(kLeft, 0, width - kLeft, it.bottom)}</clipPath>` +
    group(`clip-path="url(#${id})"`, [
      box(kLeft, ground, width - kLeft, it.bottom - ground, 'class="fig-earth"'),
      ceilingOf(now, it),
      look.runs ? wedges(now, look, it) : '',
      solids(now, it),
      look.runs ? surfaces(now, it) : '',
      objects(now, it),
      look.edges ? edgesOf(now, it) : '',
      it.mirrored === null ? '' : mirrored(now, it),
      lookOf(now, it),
      walkOf(now, it),
      look.plane ? planeOf(now, it) : '',
    ]) +
    scales(it) +
    (look.runs ? numbers(now, it) : '') +
    (look.over?.(
      now,
      Object.assign((t, z) => place(t, z), { unitX: it.unitX, unitZ: it.unitZ, plane: it.plane }),
    ) ?? '') +
    (it.mirrored === null ? '' : dot(...place(0, it.mirrored), 8, 'class="fig-eye mirrored"')) +
    eyeOf(now, it, handles)
  );
}

const kFlat = ['sky', 'haze'];

function endsOf(run, now, it) {
  const options = { ceiling: it.ceiling, farthest: it.farthest * 1.1 };
  return [run.first, run.last + 1].map((row) => {
    const { depth, z } = placeOf(run, row, now.slice, options);
    return it.place(depth, z);
  });
}

function wedges(now, { sights }, it) {
  const eye = it.place(0, now.slice.eye.z);
  const current = now.step?.of === 'run' ? now.step.index : -1;
  return now.runs
    .map((run, index) => {
      const ends = endsOf(run, now, it);
      const isCurrent = index === current ? ' now' : '';
      return (
        polygon([eye, ...ends], `class="fig-wedge ${run.what}${isCurrent}"`) +
        (sights && (run.what === 'side' || isCurrent) && !run.layer
          ? ends.map((end) => line(...eye, ...end, 'class="fig-sight"')).join('')
          : '')
      );
    })
    .join('');
}

function solids(now, it) {
  const { slice, runs } = now;
  const seen = new Set(runs.map(({ hit }) => hit));
  return slice.hits
    .map((hit, index) => {
      const back = Math.min(hit.backDepth ?? Infinity, it.farthest * 1.1);
      const [left, top] = it.place(hit.depth, it.risen(hit, hit.top));
      const [right, bottom] = it.place(back, it.risen(hit, hit.bottom));
      const tops = slopeEnds(hit, 'top', slice);
      const bottoms = slopeEnds(hit, 'bottom', slice);
      if ([tops, bottoms].some(([front, behind]) => Math.abs(behind - front) > 1e-6))
        return polygon(
          [
            it.place(hit.depth, tops[0]),
            it.place(back, tops[1]),
            it.place(back, bottoms[1]),
            it.place(hit.depth, bottoms[0]),
          ],
          `class="fig-solid${seen.has(index) ? ' seen' : ''}"`,
        );
      return box(
        left,
        top,
        right - left,
        bottom - top,
        `class="fig-solid${seen.has(index) ? ' seen' : ''}"`,
      );
    })
    .join('');
}

function surfaces(now, it) {
  return now.runs
    .filter(({ what }) => !kFlat.includes(what))
    .map((run) => {
      const [from, to] = endsOf(run, now, it);
      return line(...from, ...to, `class="fig-surface ${run.what}${run.layer ? ' layer' : ''}"`);
    })
    .join('');
}

function objects(now, it) {
  return now.slice.objects
    .map((object) => {
      const [x, top] = it.place(object.depth, it.risen(object, object.top));
      const [, bottom] = it.place(object.depth, it.risen(object, object.bottom));
      return (
        line(x, top, x, bottom, 'class="fig-upright"') + dot(x, top, 3.5, 'class="fig-object"')
      );
    })
    .join('');
}

// The ceiling over the tiles that have one.
function ceilingOf(now, it) {
  const ceiling = now.map(now.eye.map).ceiling;
  if (ceiling === null) return '';
  const { walk } = now.slice;
  return walk
    .map(({ tile: [x, y], depth, portals }, index) => {
      const sign = ceiling.tiles ? [...(ceiling.tiles[y] ?? '')][x] : '.';
      if (portals > 0 || sign === undefined || sign === ' ') return '';
      const end = walk[index + 1]?.depth ?? it.farthest * 1.1;
      const [left, y1] = it.place(depth, ceiling.height);
      return line(left, y1, it.place(end, 0)[0], y1, 'class="fig-ceiling"');
    })
    .join('');
}

// The four projected edges of each block: lines to the eye, and dots on the plane.
function edgesOf(now, it) {
  const { slice } = now;
  const eye = it.place(0, slice.eye.z);
  const planeX = kLeft + it.plane;
  return slice.hits
    .map((hit) =>
      [hit.depth, hit.backDepth]
        .filter((depth) => depth > 0)
        .flatMap((depth) => [hit.top, hit.bottom].map((z) => it.place(depth, it.risen(hit, z))))
        .map(([x, y]) => {
          const share = it.plane / (x - kLeft);
          return (
            line(...eye, x, y, 'class="fig-edge"') +
            dot(x, y, 3.5, 'class="fig-edge-dot"') +
            (share < 1
              ? dot(planeX, eye[1] + (y - eye[1]) * share, 3.5, 'class="fig-edge-dot"')
              : '')
          );
        })
        .join(''),
    )
    .join('');
}

// The eye below the mirror, and what it sees, upside down in the picture.
function mirrored(now, it) {
  const { reflection } = now.slice;
  const eye = it.place(0, it.mirrored);
  const parts = [];
  for (const run of reflection.runs) {
    if (run.layer) continue;
    const surface = {
      roof: reflection.hits[run.hit]?.top,
      underside: reflection.hits[run.hit]?.bottom,
      ceiling: it.ceiling,
    }[run.what];
    const ends = [run.first, run.last + 1].map((row) => {
      const slope = -slopeOf(row, now.slice);
      const reach =
        run.what === 'side'
          ? reflection.hits[run.hit].depth
          : surface === undefined
            ? Infinity
            : (surface - it.mirrored) / slope;
      const depth = Math.min(reach >= 0 ? reach : Infinity, it.farthest * 1.1);
      return it.place(depth, it.mirrored + slope * depth);
    });
    parts.push(polygon([eye, ...ends], `class="fig-wedge mirrored ${run.what}"`));
  }
  return parts.join('');
}

// The border that the walk crosses now.
function walkOf(now, it) {
  if (now.step?.of !== 'walk' || now.step.kind === 'start') return '';
  const { depth } = now.slice.walk[now.step.index];
  const [x] = it.place(depth, 0);
  return (
    line(x, kTop, x, it.bottom, `class="fig-tick ${now.step.kind === 'x' ? 'across' : 'along'}"`) +
    mark(x, kTop + 8, now.step.kind, 7)
  );
}

// The horizon of the eye, and the middle of the picture.
function lookOf(now, it) {
  const { slice, height } = now;
  const eye = it.place(0, slice.eye.z);
  const middle = slopeOf(height / 2, slice);
  const far = it.farthest * 1.1;
  return (
    line(...eye, ...it.place(far, slice.eye.z), 'class="fig-horizon faint"') +
    (Math.abs(middle) < 1e-6
      ? ''
      : line(...eye, ...it.place(far, slice.eye.z + middle * far), 'class="fig-look"'))
  );
}

// The picture plane: where sight lines cross it, the runs stand as rows.
function planeOf(now, it) {
  const { slice, height, runs } = now;
  const depth = it.plane / it.unitX;
  const y = (row) => it.place(depth, slice.eye.z + slopeOf(row, slice) * depth)[1];
  const x = kLeft + it.plane;
  return (
    box(x - 5, y(0), 10, y(height) - y(0), 'class="fig-plane"') +
    runs
      .filter(({ layer }) => !layer)
      .map((run) =>
        box(x - 5, y(run.first), 10, y(run.last + 1) - y(run.first), `class="fig-run ${run.what}"`),
      )
      .join('')
  );
}

function numbers(now, it) {
  const taken = [];
  return now.runs
    .map((run, index) => {
      if (kFlat.includes(run.what)) return '';
      const [from, to] = endsOf(run, now, it);
      const [x, y] = [(from[0] + Math.min(to[0], it.width)) / 2, (from[1] + to[1]) / 2];
      if (x < kLeft + it.plane + 14 || x > it.width - 10 || y < 8 || y > it.bottom) return '';
      if (taken.some(([otherX, otherY]) => Math.hypot(x - otherX, y - otherY) < 19)) return '';
      taken.push([x, y]);
      return (
        dot(x, y, 9.5, 'class="fig-badge"') +
        text(x, y + 4.5, String(index + 1), 'class="fig-badge-number" text-anchor="middle"')
      );
    })
    .join('');
}

function scales(it) {
  const parts = [];
  const y = it.bottom;
  for (const depth of ticks(0, it.farthest, Math.max(2, (it.width - kLeft) / 60))) {
    const [x] = it.place(depth, 0);
    if (x > it.width - 8) continue;
    parts.push(
      line(x, y, x, y + 5, 'class="fig-measure"'),
      text(x, y + 18, String(depth), 'class="soft" text-anchor="middle"'),
    );
  }
  for (const z of ticks(it.lowest, it.highest, Math.max(2, (y - kTop) / 40))) {
    const [, height] = it.place(0, z);
    parts.push(
      text(kLeft - 24, height + 4.5, String(z).replace('-', '−'), 'class="soft" text-anchor="end"'),
      line(kLeft - 20, height, kLeft - 14, height, 'class="fig-measure"'),
    );
  }
  parts.push(text(it.width, y + 34, 'depth, units', 'class="soft" text-anchor="end"'));
  parts.push(text(0, y + 34, 'height, units', 'class="soft"'));
  return parts.join('');
}

function eyeOf(now, it, handles) {
  const eye = it.place(0, now.slice.eye.z);
  return (
    (handles.includes('eye') ? knob(...eye, 'eye', 11, 'y') : dot(...eye, 8, 'class="fig-eye"')) +
    (handles.includes('look') ? knob(...lookPlace(now, it), 'turn', 8, 'y') : '')
  );
}

// ---- Handles

const kLookReach = 110; // pixels

function lookPlace(now, it) {
  const depth = kLookReach / it.unitX;
  const [x, y] = it.place(depth, now.slice.eye.z + slopeOf(now.height / 2, now.slice) * depth);
  return [x, clamp(y, 14, it.bottom - 14)];
}

function sideHandles(now, names, it) {
  const { state, slice, eye, height } = now;
  const [x, y] = it.place(0, slice.eye.z);
  const [lookX, lookY] = lookPlace(now, it);
  const all = {
    eye: () => ({
      id: 'height',
      label: 'Height of the eye',
      axis: 'y',
      x,
      y,
      value: Number(eye.z.toFixed(2)),
      least: 0,
      greatest: Number(it.highest.toFixed(2)),
      says: `${fixed(eye.z)} units`,
      drag: (point, _, start) => ({
        // By the scale at the beginning, because the drawing grows with the eye's height.
        eye: {
          z: Math.max(
            0.01,
            Math.round((start.state.eye.z - (point.y - start.point.y) / it.unitZ) * 100) / 100,
          ),
        },
      }),
      keys: (right, down) => ({
        eye: { z: Math.max(0.01, Math.round((state.eye.z - 0.05 * (down || -right)) * 1e4) / 1e4) },
      }),
    }),
    look: () => ({
      id: 'look',
      label: 'Look up and down',
      axis: 'y',
      x: lookX,
      y: lookY,
      value: Number(eye.look.toFixed(2)),
      least: -4,
      greatest: 4,
      says: `${fixed(eye.look)} picture heights up`,
      drag(point) {
        const [depth, z] = it.back({ x: lookX, y: point.y });
        return {
          eye: {
            look:
              Math.round(((z - eye.z) / depth) * (slice.projectionDistance / height) * 1000) / 1000,
          },
        };
      },
      keys: (right, down) => ({
        eye: { look: Math.round((state.eye.look - 0.02 * (down || -right)) * 1e4) / 1e4 },
      }),
    }),
  };
  return names.filter((name) => Object.hasOwn(all, name)).map((name) => all[name]());
}
