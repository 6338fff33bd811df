// The links of a map as lines for the picture: frames of portals, gates and what opens them, ways,
// areas and finds. Takes lists of links; gives lines for <ray-caster>.mark(). Knows no element.
//
//     linkLines('yard', links, isChosen)         // isChosen(link): drawn in white
//     shownLinks(editor)                         // those that the picture is to show at present

import { blueprintAt } from './links.js';
import { kLinkLooks } from './link-looks.js';
import { boxLines } from './mark-lines.js';

const kHead = 0.22; // of an arrow, units
const kRing = 20; // lines of a ring
const kMostLines = 6000; // of the 16,384 that a picture draws

// All with the tools that work on them; else those of what is edited or pointed at.
export function shownLinks({ links, map, tool, edited, target, scene }) {
  if (tool.hasThings) return links.of(map);
  const isHere = target?.map === map && target.cell !== null;
  const { name, blueprint } = (isHere && blueprintAt(scene.value, map, target.cell)) || {};
  const isPointed = blueprint?.gate !== undefined || blueprint?.motion !== undefined;
  if (!isPointed && edited === null) return [];
  return links
    .of(map)
    .filter(
      (link) =>
        isOfThing(link, edited) ||
        (isPointed && link.kind === 'gate' && link.path[1] === name) ||
        (isPointed && link.kind === 'mover' && link.text === name),
    );
}

// A link of what stands at a path, or within it.
export function isOfThing({ path }, thing) {
  if (thing === null) return false;
  const [short, long] = path.length < thing.length ? [path, thing] : [thing, path];
  const isOne = short.length > 1 || ['start', 'game'].includes(short[0]);
  return isOne && short.every((key, index) => key === long[index]);
}

export function linkLines(map, links, isChosen = () => false) {
  const lines = links.flatMap((link) => {
    const colour = isChosen(link) ? '#ffffff' : kLinkLooks[link.kind].colour;
    return linesOf(link)
      .filter((ends) => ends.flat().every(Number.isFinite))
      .map(([from, to]) => ({ map, from, to, colour }));
  });
  return lines.slice(0, kMostLines);
}

function linesOf(link) {
  const { kind, map, area, areas, points, radius, ends, isClosed, isBack } = link;
  const boxes = (areas ?? [area]).filter(Boolean).flatMap(edgesOf);
  switch (kind) {
    case 'portal': {
      const isHere = ends.every((end) => end.map === map);
      return isHere ? [...boxes, ...arrow(...ends.map(pointOf), isBack)] : boxes;
    }
    case 'gate':
      return [
        ...boxes,
        ...ends.filter((end) => end.map === map).flatMap((end) => arrow(pointOf(end), points[0])),
      ];
    case 'goal':
      return [
        ...boxes,
        ...ends
          .filter((end) => end.map === map)
          .map((end) => [pointOf(end), [(area.west + area.east) / 2, area.north, area.low]]),
      ];
    case 'find':
      return points.flatMap(diamond);
    default:
      return [
        ...boxes,
        ...wayOf(points, link, isClosed, isBack),
        ...(radius === null ? [] : ring(points[0], radius)),
      ];
  }
}

const pointOf = ({ x, y, z }) => [x, y, z];

const edgesOf = (box) => {
  const seen = new Set();
  return boxLines('', box, '')
    .map(({ from, to }) => [from, to])
    .filter(([from, to]) => {
      const key = [from, to].map(String).sort().join(' ');
      const isNew = String(from) !== String(to) && !seen.has(key);
      seen.add(key);
      return isNew;
    });
};

function wayOf(points, { closesAt = 0, kind }, isClosed, isBack) {
  if (points.length < 2) return [];
  const last = points.at(-1);
  const isRing = kind === 'way' && points.length > 12 && isClosed; // what flies in circles
  return [
    ...points
      .slice(1)
      .flatMap((to, index) =>
        isRing ? [[points[index], to]] : arrow(points[index], to, isBack && index >= closesAt),
      ),
    ...(isClosed ? arrow(last, points[closesAt]) : []),
  ];
}

function arrow(from, to, isBack = false) {
  const far = Math.hypot(...to.map((value, axis) => value - from[axis]));
  if (far < 1e-6) return [];
  return [[from, to], ...headAt(to, from, far), ...(isBack ? headAt(from, to, far) : [])];
}

// Two strokes, flat over the ground, or upright where the arrow is.
function headAt(tip, from, far) {
  const size = Math.min(kHead, far / 3);
  const [x, y, z] = tip.map((value, axis) => (value - from[axis]) / far);
  const flat = Math.hypot(x, y);
  const side = flat < 0.2 ? [1, 0, 0] : [-y / flat, x / flat, 0];
  return [-0.6, 0.6].map((aside) => [
    tip,
    [x, y, z].map((ahead, axis) => tip[axis] - size * (ahead + aside * side[axis])),
  ]);
}

function ring([x, y, z], radius) {
  const at = (index) => {
    const angle = (2 * Math.PI * index) / kRing;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle), z];
  };
  return Array.from({ length: kRing }, (_, index) => [at(index), at(index + 1)]);
}

function diamond([x, y, z]) {
  const size = 0.2;
  const corners = [
    [x - size, y, z],
    [x, y, z + size],
    [x + size, y, z],
    [x, y, z - size],
  ];
  const across = corners.map(([cx, , cz]) => [x, y + cx - x, cz]);
  return [corners, across].flatMap((square) =>
    square.map((corner, index) => [corner, square[(index + 1) % 4]]),
  );
}
