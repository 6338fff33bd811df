// Worlds to begin with. Gives scenes as objects; their pictures are the shipped ones.
//
//     templates      // [{name, title, scene(), view}]
//
// `view` is where its picture is drawn from, else its start (tools/scene-posters.mjs).

const kBlueprints = {
  'stone wall': { faces: { all: 'stone-blocks-worn', top: 'flagstones' } },
  'brick wall': { faces: { all: 'brick-weathered', top: 'flagstones' } },
  'wooden wall': { faces: { all: 'planks-wall', top: 'planks-floor' } },
  'plastered wall': { faces: { all: 'timber-frame', top: 'planks-floor' } },
  window: { faces: { all: 'window-brick', top: 'flagstones' } },
  rock: { faces: { all: 'rock', top: 'moss' } },
  bank: { faces: { all: 'earth', sides: 'turf', top: 'grass-meadow' } },
  hedge: { faces: 'hedge' },
  step: { top: 0.5, faces: { all: 'stone-blocks-worn', top: 'flagstones' } },
  slab: { top: 0.2, faces: { all: 'planks-floor' } },
  ramp: { top: [0, 1], rise: 'east', faces: { all: 'stone-blocks-worn', top: 'flagstones' } },
  roof: { top: [0, 1], rise: 'south', faces: { all: 'planks-wall', top: 'roof-slate' } },
  glass: { faces: 'stained-glass' },
};

const kLegend = {
  '#': 'stone wall',
  b: 'brick wall',
  w: 'wooden wall',
  p: 'plastered wall',
  o: 'window',
  r: 'rock',
  e: 'bank',
  h: 'hedge',
  s: 'step',
  '=': 'slab',
  '/': 'ramp',
  '^': 'roof',
  g: 'glass',
};

const kDay = { low: '#d4e0d9', high: '#5b8fc7', sun: {}, clouds: { cover: 0.35 } };
const kLight = { sun: { azimuth: 125, altitude: 42 }, ambient: '#8fa3b8' };
const kNoLight = { on: false };

function made(title, levels, start, map = {}) {
  return {
    title,
    textures: { sand: '../textures/sand.png' },
    sprites: {
      oak: '../sprites/oak.png',
      birch: '../sprites/birch.png',
      bush: '../sprites/flower-bush.png',
    },
    blueprints: kBlueprints,
    legend: kLegend,
    maps: [
      {
        name: 'world',
        levels,
        floor: 'grass-meadow',
        objects: [],
        sky: kDay,
        light: kNoLight,
        baked: kLight,
        fog: { start: 40, end: 160 },
        haze: '#d4e0d9',
        ...map,
      },
    ],
    start,
  };
}

// Rows from a function of the tile.
function rows(width, depth, signAt) {
  return Array.from({ length: depth }, (_, y) =>
    Array.from({ length: width }, (__, x) => signAt(x, y)).join(''),
  );
}

const empty = (width, depth) => rows(width, depth, () => '.');
const isEdge = (x, y, width, depth, inset = 0) =>
  x === inset || y === inset || x === width - 1 - inset || y === depth - 1 - inset;

function walled(width, depth, sign) {
  return rows(width, depth, (x, y) => (isEdge(x, y, width, depth) ? sign : '.'));
}

// A hill of noise that is the same for everybody.
function wave(x, y, seed) {
  return (
    Math.sin(x * 0.55 + seed) * Math.cos(y * 0.43 - seed) + Math.sin((x + y) * 0.31 + 2 * seed)
  );
}

function lawn() {
  return made('A meadow', [empty(32, 32), []], { x: 16.5, y: 20.5, heading: 270 });
}

function garden() {
  const [width, depth] = [28, 24];
  const ground = rows(width, depth, (x, y) => {
    if (isEdge(x, y, width, depth)) return y === depth - 1 && Math.abs(x - 13.5) < 1 ? '.' : 'b';
    const isBed = x > 3 && x < width - 4 && y > 3 && y < depth - 4 && x % 6 > 1 && y % 6 > 1;
    const isRim = isBed && (x % 6 === 2 || x % 6 === 5 || y % 6 === 2 || y % 6 === 5);
    return isRim && Math.abs(x - 13.5) > 1 ? 'h' : '.';
  });
  return made('A walled garden', [ground, walled(width, depth, '.'), []], {
    x: 14,
    y: 21.5,
    heading: 270,
  });
}

function house() {
  const [width, depth] = [28, 24];
  const isIn = (x, y) => x >= 9 && x <= 18 && y >= 7 && y <= 14;
  const isWall = (x, y) => isIn(x, y) && (x === 9 || x === 18 || y === 7 || y === 14);
  const storey = (hasDoor) =>
    rows(width, depth, (x, y) => {
      if (!isWall(x, y)) return '.';
      if (hasDoor && y === 14 && (x === 13 || x === 14)) return '.';
      return (x + y) % 3 === 0 && !((x === 9 || x === 18) && (y === 7 || y === 14)) ? 'o' : 'b';
    });
  const roof = rows(width, depth, (x, y) => (isIn(x, y) ? '=' : '.'));
  return made('A house', [storey(true), storey(false), roof], { x: 14, y: 22.5, heading: 270 });
}

function cave() {
  const [width, depth] = [36, 28];
  const level = (height) =>
    rows(width, depth, (x, y) => {
      if (isEdge(x, y, width, depth)) return 'r';
      const open = wave(x, y, 1.3) + 0.9 - 0.45 * height;
      const isMouth = Math.hypot(x - 6, y - 14) < 4 - height;
      return open > 0 || isMouth ? '.' : 'r';
    });
  const roof = rows(width, depth, (x, y) => (Math.hypot(x - 26, y - 12) < 2.5 ? '.' : 'r'));
  return made(
    'A cave',
    [level(0), level(1), roof],
    { x: 6.5, y: 14.5, heading: 0 },
    { floor: 'sand' },
  );
}

function canyon() {
  const [width, depth] = [40, 28];
  const wallAt = (x) => 11 + 3.4 * Math.sin(x * 0.32) + 1.4 * Math.sin(x * 0.9);
  const level = (height) =>
    rows(width, depth, (x, y) => {
      const far = Math.abs(y - wallAt(x) - 2.5);
      return far > 2.6 + height * 1.1 ? 'r' : '.';
    });
  const start = { x: 2.5, y: Math.round(wallAt(2) + 2.5) + 0.5, heading: 0 };
  return made('A canyon', [level(0), level(1), level(2), level(3)], start, { floor: 'sand' });
}

function tower() {
  const [width, depth] = [28, 28];
  const isIn = (x, y) => x >= 11 && x <= 16 && y >= 11 && y <= 16;
  const level = (height) =>
    rows(width, depth, (x, y) => {
      if (!isIn(x, y)) return '.';
      const isWall = x === 11 || x === 16 || y === 11 || y === 16;
      if (!isWall) return '.';
      if (height === 0 && y === 16 && (x === 13 || x === 14)) return '.';
      return height % 2 === 1 && (x + y) % 4 === 0 && x !== y ? 'o' : '#';
    });
  const top = rows(width, depth, (x, y) => (isIn(x, y) ? '#' : '.'));
  const crown = rows(width, depth, (x, y) =>
    isIn(x, y) && (x === 11 || x === 16 || y === 11 || y === 16) && (x + y) % 2 === 0 ? '#' : '.',
  );
  return made('A tower', [level(0), level(1), level(2), level(3), level(4), top, crown], {
    x: 14,
    y: 23.5,
    heading: 270,
  });
}

export const templates = [
  { name: 'meadow', title: 'An empty meadow', scene: lawn },
  {
    name: 'garden',
    title: 'A walled garden',
    scene: garden,
    view: { x: 23, y: 30, z: 10, heading: 245, look: -0.42 },
  },
  {
    name: 'house',
    title: 'A house',
    scene: house,
    view: { x: 22.5, y: 23, z: 4.5, heading: 235, look: -0.22 },
  },
  {
    name: 'cave',
    title: 'A cave',
    scene: cave,
    view: { x: 20, y: 14, z: 0.8, heading: 330, look: 0.05 },
  },
  {
    name: 'canyon',
    title: 'A canyon',
    scene: canyon,
    view: { x: 8, y: 22, z: 9, heading: 325, look: -0.45 },
  },
  {
    name: 'tower',
    title: 'A tower',
    scene: tower,
    view: { x: 22, y: 26, z: 6.5, heading: 236, look: -0.2 },
  },
];
