// A scene out of plain rows of characters, as one types them into a page: the north edge first, one
// character for each tile.
//
//     const scene = sceneOfRows('#####\n#>..#\n#####', {title: 'A room'});
//
// It throws a Trouble that lists every fault: rows:3:5 is the fifth character of the third row.
//
//     | characters      | what stands there                                                                          |
//     | --------------- | ------------------------------------------------------------------------------------------ |
//     | . , ~           | floor: paving, cobbles, water                                                              |
//     | blank           | floor: grass, also where a row is short and outside of the rows                            |
//     | # b s r w p m h | a wall one block high: stone, brick, sandstone, rubble, wood, plaster, marble, hedge       |
//     | % B S R W P M H | the same two blocks high                                                                   |
//     | o O             | a brick wall with windows, one and two blocks high                                         |
//     | 1 2 3 ... 9     | a step of so many tenths of a block; up to five tenths are climbed at once                 |
//     | =               | a bridge: a slab, its top one block high                                                   |
//     | +               | a door that opens for who comes near                                                       |
//     | t T * i         | a birch, an oak, a bush in flower, a street lamp                                           |
//     | > v < ^         | the start, looking east, south, west or north; exactly one                                 |
//
// Objects and the start stand on the floor of a tile beside them. Indentation that all rows share
// is left out, and so are empty rows before and after.

import { sceneFault } from './faults.js';

const kFloors = { ' ': 'grass-meadow', '.': 'flagstones', ',': 'cobbles', '~': 'water' };
const kPavedLetter = 'p'; // a floor's legend keeps the full stop for the floor's own texture

// Of one block; the same twice as high has the other character.
const kWalls = {
  '#': { name: 'stone wall', high: '%', sides: 'stone-blocks-worn', top: 'flagstones' },
  b: { name: 'brick wall', high: 'B', sides: 'brick-weathered', top: 'flagstones' },
  s: { name: 'sandstone wall', high: 'S', sides: 'sandstone', top: 'sandstone' },
  r: { name: 'rubble wall', high: 'R', sides: 'stone-rubble', top: 'flagstones' },
  w: { name: 'wooden wall', high: 'W', sides: 'planks-wall', top: 'planks-floor' },
  p: { name: 'plastered wall', high: 'P', sides: 'timber-frame', top: 'planks-floor' },
  m: { name: 'marble wall', high: 'M', sides: 'marble-dark', top: 'marble-checker' },
  h: { name: 'hedge', high: 'H', sides: 'hedge', top: 'hedge' },
  o: { name: 'brick wall with windows', high: 'O', sides: 'window-brick', top: 'flagstones' },
};
const kLowOfHigh = Object.fromEntries(Object.entries(kWalls).map(([low, { high }]) => [high, low]));

const kObjects = {
  t: { sprite: 'birch', height: 2.4 },
  T: { sprite: 'oak', height: 3.2 },
  '*': { sprite: 'flower-bush', height: 0.55 },
  i: { sprite: 'street-lamp', height: 1.5 },
};

const kHeadings = { '>': 0, v: 90, '<': 180, '^': 270 };
const kSteps = '123456789';
const kBridge = '=';
const kDoor = '+'; // in the levels: one that is seen from north and south
const kDoorAcross = '|'; // in the levels only: one that is seen from east and west

const kLegend = new Set([
  ...Object.keys(kFloors),
  ...Object.keys(kWalls),
  ...Object.keys(kLowOfHigh),
  ...kSteps,
  kBridge,
  kDoor,
  ...Object.keys(kObjects),
  ...Object.keys(kHeadings),
]);

// An object as a scene file holds it, for the folder of the shipped scenes; `name` stands in
// messages.
export function sceneOfRows(text, { title = 'A map', name = 'rows' } = {}) {
  const rows = rowsOf(text);
  const tiles = rows.flatMap((row, y) => row.map((character, x) => ({ character, x, y })));
  const faults = faultsOf(tiles, (tile, found, expected) => faultAt(name, tile, found, expected));
  if (faults.length > 0) throw sceneFault(name, faults);

  const start = tiles.find(({ character }) => character in kHeadings);
  const levels = levelsOf(rows);
  const letters = [...new Set(levels.flat().join(''))].filter((letter) => letter !== '.');
  const legend = Object.fromEntries(letters.map((letter) => [letter, blueprintName(letter)]));
  const blueprints = Object.fromEntries(
    Object.entries(legend).map(([letter, blueprint]) => [blueprint, blueprintOf(letter)]),
  );
  const objects = tiles
    .filter(({ character }) => character in kObjects)
    .map(({ character, x, y }) => ({ ...kObjects[character], x: x + 0.5, y: y + 0.5 }));
  const floor = floorOf(rows);
  return {
    title,
    textures: texturesOf(blueprints, floor),
    sprites: Object.fromEntries(objects.map(({ sprite }) => [sprite, `../sprites/${sprite}.png`])),
    blueprints,
    legend,
    maps: [
      {
        name: 'map',
        levels,
        floor,
        objects,
        sky: { panorama: '../textures/sky-day.png' },
        light: { multiplier: 8, darkest: 0.45 },
        fog: { start: 14, end: 70 },
        haze: '#d4e0d9',
      },
    ],
    start: { x: start.x + 0.5, y: start.y + 0.5, heading: kHeadings[start.character] },
  };
}

// Rows of single characters, all of one length.
function rowsOf(text) {
  const lines = text
    .replaceAll('\r', '')
    .split('\n')
    .map((line) => line.trimEnd());
  const isEmpty = (line) => line === '';
  const first = lines.findIndex((line) => !isEmpty(line));
  if (first < 0) return [];
  const kept = lines.slice(first, lines.findLastIndex((line) => !isEmpty(line)) + 1);
  const indentation = Math.min(
    ...kept.filter((line) => !isEmpty(line)).map((line) => /^[ \t]*/.exec(line)[0].length),
  );
  const rows = kept.map((line) => [...line.slice(indentation)]);
  const width = Math.max(...rows.map((row) => row.length));
  return rows.map((row) => [...row, ...new Array(width - row.length).fill(' ')]);
}

function faultsOf(tiles, fault) {
  const expected = `one of ${[...kLegend].filter((character) => character !== ' ').join(' ')} or a blank`;
  const unknown = tiles
    .filter(({ character }) => !kLegend.has(character))
    .map((tile) => fault(tile, JSON.stringify(tile.character), expected));
  const starts = tiles.filter(({ character }) => character in kHeadings);
  const isStart = 'one start, < > ^ or v';
  if (starts.length === 0)
    return [...unknown, fault(null, tiles.length === 0 ? 'no rows' : 'no start', isStart)];
  return [
    ...unknown,
    ...starts.slice(1).map((tile) => fault(tile, `another start, ${tile.character}`, isStart)),
  ];
}

// As the engine tells faults. Line and column are those of the rows as they are shown, without what
// is left out; 0 where there is no place.
function faultAt(name, tile, found, expected) {
  const [line, column] = tile === null ? [0, 0] : [tile.y + 1, tile.x + 1];
  const message = `${tile === null ? name : `${name}:${line}:${column}`}: found ${found}, expected ${expected}`;
  return {
    file: name,
    pointer: '',
    line,
    column,
    row: -1,
    character: -1,
    found,
    expected,
    message,
  };
}

function levelsOf(rows) {
  const ground = rows.map((row, y) =>
    row
      .map((character, x) => {
        if (character === kDoor)
          return isWall(rows[y][x - 1]) || isWall(rows[y][x + 1]) ? kDoor : kDoorAcross;
        const letter = kLowOfHigh[character] ?? character;
        return letter in kWalls || kSteps.includes(letter) || letter === kBridge ? letter : '.';
      })
      .join(''),
  );
  const above = rows.map((row) => row.map((character) => kLowOfHigh[character] ?? '.').join(''));
  return above.some((row) => /[^.]/.test(row)) ? [ground, above] : [ground];
}

function isWall(character) {
  return character in kWalls || character in kLowOfHigh;
}

function blueprintName(letter) {
  if (letter in kWalls) return kWalls[letter].name;
  if (letter === kBridge) return 'bridge';
  if (letter === kDoor) return 'door';
  return letter === kDoorAcross ? 'side door' : `step ${letter}`;
}

function blueprintOf(letter) {
  if (letter in kWalls) return { faces: faces(kWalls[letter].sides, kWalls[letter].top) };
  if (letter === kBridge)
    return {
      bottom: 0.8,
      faces: {
        ...faces('planks-floor', 'planks-floor'),
        bottom: { texture: 'planks-floor', light: 0.7 },
      },
    };
  if (letter === kDoor)
    return {
      gate: { approach: 1.6, hold: 1.5 },
      faces: { all: 'nothing', north: 'double-door', south: 'double-door' },
    };
  if (letter === kDoorAcross)
    return {
      gate: { approach: 1.6, hold: 1.5 },
      faces: { all: 'nothing', east: 'double-door', west: 'double-door' },
    };
  return { top: Number(letter) / 10, faces: faces('stone-blocks', 'flagstones') };
}

// The sides are lit from the south-west, so that corners show.
function faces(sides, top) {
  return {
    all: sides,
    north: { texture: sides, light: 0.76 },
    east: { texture: sides, light: 0.86 },
    west: { texture: sides, light: 0.94 },
    top,
  };
}

// Under what stands on a tile the floor goes on from beside it.
function floorOf(rows) {
  const isFloor = (character) => character in kFloors;
  const tiles = rows.map((row) =>
    row
      .map((character, x) => {
        const beside = [character, row[x - 1] ?? '', row[x + 1] ?? ''].find(isFloor) ?? '.';
        return beside === '.' ? kPavedLetter : beside;
      })
      .join(''),
  );
  const letters = { [kPavedLetter]: kFloors['.'], ',': kFloors[','], '~': kFloors['~'] };
  const used = Object.entries(letters).filter(([letter]) =>
    tiles.some((row) => row.includes(letter)),
  );
  return { texture: kFloors[' '], legend: Object.fromEntries(used), tiles };
}

const kElsewhere = {
  'double-door': { file: '../sheets/double-door.png', frames: 8 },
  nothing: '../see-through/nothing.png',
};

function texturesOf(blueprints, floor) {
  const ofBlocks = Object.values(blueprints).flatMap((blueprint) =>
    Object.values(blueprint.faces).map((face) => face.texture ?? face),
  );
  const names = [floor.texture, ...Object.values(floor.legend), ...ofBlocks];
  return Object.fromEntries(
    [...new Set(names)].map((name) => [name, kElsewhere[name] ?? `../textures/${name}.png`]),
  );
}
