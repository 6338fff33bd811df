// Makes a scene from plain rows of characters as one types them into a page: the north edge first,
// one character per tile.
//
//     const scene = sceneOfRows('#####\n#>..#\n#####', {title: 'A room'});
//     const scene = sceneOfRows([['#####', '#>.x#'], ['##', '...x']],          // two levels
//       {legend: {x: '#c03020'}, colours: true});
//     new URL(file, isShippedFile(file) ? scenes : mine)          // resolves a file that it names
//
// It throws a Trouble that lists every fault: rows:3:5 is the fifth character of the third row.
//
//     | characters      | meaning                                                              |
//     | --------------- | -------------------------------------------------------------------- |
//     | . , ~           | floor: paving, cobbles, water to wade in                             |
//     | blank           | floor: grass; also fills short rows and the land around the rows     |
//     | # b s r w p m h | a wall one block high: stone, brick, sandstone, rubble, wood,        |
//     |                 | plaster, marble, hedge                                               |
//     | % B S R W P M H | the same, two blocks high                                            |
//     | o O             | a brick wall with windows, one and two blocks high                   |
//     | 1 2 3 ... 9     | a step, so many tenths of a block high; one climbs up to five tenths |
//     | =               | a bridge: a slab whose top is one block high                         |
//     | +               | a door that opens when someone comes near                            |
//     | t T * i         | a birch, an oak, a bush in flower, a street lamp                     |
//     | > v < ^         | the start, looking east, south, west or north; exactly one           |
//
// Objects and the start stand on the floor of a neighbouring tile. Indentation that all rows share
// is removed, and so are empty rows before and after.
//
// A line of dashes begins the next level, one block higher, where floors and blanks are air. After
// `--- legend` each line gives a character another meaning; `--- colours` uses plain colours
// instead of textures:
//
//     #####       --- legend
//     #>.x#       x = #c03020              a wall of that colour
//     #####       q = brick-mossy          a wall with that shipped texture
//     ---         z = pictures/wall.png    a wall with your own picture
//     ####        y = sandstone 0.5        half as high
//                 g = sand floor           a floor
//                 # = brick                # with another texture; also `blank` and `sky`
//                 1 = #                    what # means, as for maps of numbers

import { padded, readRows } from './rows-text.js';
import { signsOf } from './signs.js';
import { sceneFault } from './trouble.js';

const kWater = 'water'; // the texture to wade in
const kFloors = { ' ': 'grass-meadow', '.': 'flagstones', ',': 'cobbles', '~': kWater };
const kFloorLetter = '▪'; // replaces the full stop, which a floor's legend reserves for its texture

// Walls of one block; `high` is the character of the same wall twice as high.
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
const kDoor = '+'; // in the levels: a door that faces north and south
const kDoorAcross = '‖'; // in the levels only: a door that faces east and west

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

const kElsewhere = {
  'double-door': { file: '../sheets/double-door.png', frames: 8 },
  nothing: '../see-through/nothing.png',
};

// Used instead of textures; doors and objects keep their pictures.
const kColours = {
  'grass-meadow': '#6f9a4c',
  flagstones: '#b3aa97',
  cobbles: '#8c8379',
  water: '#3f78a8',
  'stone-blocks-worn': '#8f8b84',
  'stone-blocks': '#9d968a',
  'brick-weathered': '#a85a44',
  sandstone: '#d2b27a',
  'stone-rubble': '#77726a',
  'planks-wall': '#96683d',
  'planks-floor': '#b48c58',
  'timber-frame': '#dccfb4',
  'marble-dark': '#4d5563',
  'marble-checker': '#d8d4cc',
  hedge: '#3f6b34',
  'window-brick': '#8a6472',
};
const kSkyColours = { low: '#d4e0d9', high: '#5b8fc7' };

const isSign = (text) => signsOf(text).length === 1;

const kColour = /^#([0-9a-f]{3}){1,2}$/i;
const kUnfit = /^[\p{C}\p{M}\p{Z}‖▪]|^\p{RI}$|\u200d$/u; // the engine takes no such signs; two are our own
const kMeaning =
  'a texture, a colour as #c03020 or a .png file; behind it "floor" or a height up to 1';
const kRows =
  'a text, a list of rows, or a list of levels of rows; a row is a text, or a list of numbers from 0 to 9';
const kMostTiles = 2 ** 20; // on all levels together: far more than people type
const kMostFaults = 1000; // a longer list helps nobody
const kOfMap = ['sky', 'light', 'fog', 'haze'];

// Returns an object as in a scene file; `name` appears in messages. An entry of `legend` is a text
// as in the rows, or a blueprint; `textures` are as in a scene file; sky, light, fog and haze as in
// a map.
export function sceneOfRows(
  rows,
  { title = 'A map', name = 'rows', legend, textures, ...rest } = {},
) {
  const { levels: texts, size, strays, wrong, ...inText } = readRows(rows);
  if (wrong !== undefined)
    throw sceneFault(name, [faultAt(name, null, `the rows ${wrong}`, kRows)]);
  checkSize(name, texts.length, size);
  const hasColours = inText.colours || rest.colours === true;
  const own = readLegend({ ...inText.legend, ...legend });
  const levels = padded(texts).map((level) =>
    level.map((row) => row.map((character) => own.alike.get(character) ?? character)),
  );
  const tiles = levels.flatMap((level, z) =>
    level.flatMap((row, y) => row.map((character, x) => ({ character, x, y, z }))),
  );
  const fault = (tile, found, expected) =>
    faultAt(
      tile !== null && levels.length > 1 ? `${name}, level ${tile.z}` : name,
      tile,
      found,
      expected,
    );
  const faults = [
    ...tileFaults(tiles, own, fault),
    ...own.faults.map(([found, expected]) => fault(null, found, expected)),
    ...strays.map((line) =>
      fault(
        null,
        JSON.stringify(line),
        'CHARACTER = MEANING, or one of --- --- legend --- colours',
      ),
    ),
    ...Object.keys(rest)
      .filter((key) => ![...kOfMap, 'colours'].includes(key))
      .map((key) => fault(null, `the key "${key}"`, `some of ${kOfKeys.join(', ')}`)),
  ];
  if (faults.length > 0) throw sceneFault(name, faults.slice(0, kMostFaults));

  const start = tiles.find(({ character }) => isStart(character, own));
  const blocks = levelsOf(levels, own);
  const letters = [...new Set(blocks.flat().flatMap(signsOf))].filter((letter) => letter !== '.');
  const blueprints = Object.fromEntries(
    letters.map((letter) => [blueprintName(letter, own), blueprintOf(letter, own)]),
  );
  const objects = tiles
    .filter(({ character }) => Object.hasOwn(kObjects, character) && !own.blocks.has(character))
    .map(({ character, x, y, z }) => ({
      ...kObjects[character],
      x: x + 0.5,
      y: y + 0.5,
      ...(z > 0 && { z }),
    }));
  const floor = floorOf(levels[0], own);
  const { sky, haze } = surroundingsOf(own.sky, hasColours);
  return {
    title,
    textures: texturesOf(blueprints, floor, textures, hasColours),
    sprites: Object.fromEntries(objects.map(({ sprite }) => [sprite, `../sprites/${sprite}.png`])),
    blueprints,
    legend: Object.fromEntries(letters.map((letter) => [letter, blueprintName(letter, own)])),
    maps: [
      {
        name: 'map',
        levels: blocks,
        floor,
        objects,
        sky,
        light: hasColours ? { on: false } : { multiplier: 8, darkest: 0.75 },
        fog: { start: 30, end: 1500 },
        haze,
        ...Object.fromEntries(
          kOfMap.filter((key) => Object.hasOwn(rest, key)).map((key) => [key, rest[key]]),
        ),
      },
    ],
    start: {
      x: start.x + 0.5,
      y: start.y + 0.5,
      ...(start.z > 0 && { z: start.z }),
      heading: kHeadings[start.character],
    },
  };
}

// Short rows are filled up, so one long row among many short ones makes many tiles.
function checkSize(name, levels, { width, depth }) {
  if (width * depth * levels <= kMostTiles) return;
  const found = `${width} x ${depth} tiles${levels > 1 ? ` on ${levels} levels` : ''}`;
  const expected = `at most ${kMostTiles} on all levels together`;
  throw sceneFault(name, [faultAt(name, null, found, expected)]);
}

const kOfKeys = ['rows', 'title', 'legend', 'textures', 'colours', ...kOfMap];

// Makes a scene from an object {rows, legend, ...}.
export function sceneOfObject({ rows, ...others }, name) {
  return sceneOfRows(rows, { name, ...others });
}

// ---- The legend

// Returns {floors: character -> texture, blocks: character -> {texture, height} or {blueprint},
// alike: character -> the one whose meaning it has, sky, faults, named: all characters}.
function readLegend(legend) {
  const own = {
    floors: { ...kFloors },
    blocks: new Map(),
    alike: new Map(),
    sky: null,
    faults: [],
    named: Object.keys(legend),
  };
  for (const [key, meaning] of Object.entries(legend)) {
    const character = key === 'blank' ? ' ' : key;
    const [texture, ...more] = typeof meaning === 'string' ? meaning.trim().split(/\s+/) : [null];
    const isFloor =
      more.includes('floor') || (Object.hasOwn(kFloors, character) && more.length === 0);
    const [height = null] = more.filter((word) => word !== 'floor').map(Number);
    const isSound =
      more.length <= 1 &&
      !Object.hasOwn(kHeadings, character) &&
      (texture === null
        ? typeof meaning === 'object' && meaning !== null
        : (kColour.test(texture) || /^[\w-]+$|\.png$/i.test(texture)) &&
          (height === null || (height > 0 && height <= 1)));
    if (kLegend.has(meaning) && isSign(character)) own.alike.set(character, meaning);
    else if (key === 'sky' && isSound) own.sky = texture ?? meaning;
    else if (!isSign(character) || !isSound)
      own.faults.push([`the meaning of "${key}", ${JSON.stringify(meaning)}`, kMeaning]);
    else if (!isFloor && (character === ' ' || character === '.'))
      own.faults.push([`"${key}" as a block`, 'another character: this one is always a floor']);
    else if (kUnfit.test(character) && character !== ' ')
      own.faults.push([
        `the character ${JSON.stringify(key)}`,
        'one that is printed and is not ‖ or ▪',
      ]);
    else if (isFloor) own.floors[character] = fullColour(texture);
    else if (texture === null) own.blocks.set(character, { blueprint: meaning });
    else own.blocks.set(character, { texture: fullColour(texture), height });
  }
  return own;
}

function isStart(character, own) {
  return Object.hasOwn(kHeadings, character) && !own.blocks.has(character);
}

// "#c32" is "#cc3322".
function fullColour(texture) {
  return /^#[0-9a-f]{3}$/i.test(texture) ? texture.replace(/[0-9a-f]/gi, '$&$&') : texture;
}

function tileFaults(tiles, own, fault) {
  const known = new Set([...kLegend, ...own.named.filter(isSign)]);
  const expected = `one of ${[...known].filter((character) => character !== ' ').join(' ')} or a blank`;
  const unknown = tiles
    .filter(({ character }) => !known.has(character))
    .slice(0, kMostFaults)
    .map((tile) => fault(tile, JSON.stringify(tile.character), expected));
  const starts = tiles.filter(({ character }) => isStart(character, own));
  const oneStart = 'one start, < > ^ or v';
  if (starts.length === 0)
    return [...unknown, fault(null, tiles.length === 0 ? 'no rows' : 'no start', oneStart)];
  return [
    ...unknown,
    ...starts
      .slice(1, kMostFaults)
      .map((tile) => fault(tile, `another start, ${tile.character}`, oneStart)),
  ];
}

// A fault in the engine's form. Line and column count the rows without what was removed; 0 if the
// fault has no place.
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

// ---- Blocks

function levelsOf(levels, own) {
  const isWall = (character) =>
    Object.hasOwn(kWalls, character) ||
    Object.hasOwn(kLowOfHigh, character) ||
    own.blocks.has(character);
  const letterAt = (rows, row, y, x) => {
    const character = row[x];
    if (own.blocks.has(character)) return character;
    if (character === kDoor)
      return isWall(rows[y][x - 1]) || isWall(rows[y][x + 1]) ? kDoor : kDoorAcross;
    const letter = kLowOfHigh[character] ?? character;
    return Object.hasOwn(kWalls, letter) || kSteps.includes(letter) || letter === kBridge
      ? letter
      : '.';
  };
  const letters = levels.map((rows) =>
    rows.map((row, y) => row.map((_, x) => letterAt(rows, row, y, x))),
  );
  const depth = levels[0].length;
  const raised = levels.map((rows) =>
    rows.some((row) => row.some((one) => Object.hasOwn(kLowOfHigh, one))),
  );
  if (raised.at(-1)) letters.push(Array.from({ length: depth }, () => levels[0][0].map(() => '.')));
  // High walls continue on the level above if that cell is empty.
  levels.forEach((rows, z) =>
    rows.forEach((row, y) =>
      row.forEach((character, x) => {
        if (Object.hasOwn(kLowOfHigh, character) && letters[z + 1][y][x] === '.')
          letters[z + 1][y][x] = letters[z][y][x];
      }),
    ),
  );
  while (
    letters.length > 1 &&
    letters
      .at(-1)
      .flat()
      .every((letter) => letter === '.')
  )
    letters.pop();
  return letters.map((rows) => rows.map((row) => row.join('')));
}

function blueprintName(letter, own) {
  if (letter === kBridge) return 'bridge';
  if (letter === kDoor) return 'door';
  if (letter === kDoorAcross) return 'side door';
  if (Object.hasOwn(kWalls, letter)) return kWalls[letter].name;
  return kSteps.includes(letter) && !own.blocks.has(letter) ? `step ${letter}` : `block ${letter}`;
}

function blueprintOf(letter, own) {
  const { blueprint = null, texture = null, height = null } = own.blocks.get(letter) ?? {};
  if (blueprint !== null) return blueprint;
  if (letter === kBridge) return bridgeOf(texture ?? 'planks-floor');
  if (texture === null && letter === kDoor)
    return doorOf({ north: 'double-door', south: 'double-door' });
  if (texture === null && letter === kDoorAcross)
    return doorOf({ east: 'double-door', west: 'double-door' });
  const top = height ?? (kSteps.includes(letter) ? Number(letter) / 10 : 1);
  const { sides, top: above } = kWalls[letter] ?? { sides: 'stone-blocks', top: 'flagstones' };
  return {
    ...(top < 1 && { top }),
    faces: faces(texture ?? sides, texture ?? above),
  };
}

function bridgeOf(texture) {
  return {
    bottom: 0.8,
    faces: { ...faces(texture, texture), bottom: { texture, light: 0.7 } },
  };
}

function doorOf(leaves) {
  return { gate: { approach: 1.6, hold: 1.5 }, faces: { all: 'nothing', ...leaves } };
}

// Lights the sides from the south-west, so that corners show.
function faces(sides, top) {
  return {
    all: sides,
    north: { texture: sides, light: 0.76 },
    east: { texture: sides, light: 0.86 },
    west: { texture: sides, light: 0.94 },
    top,
  };
}

// ---- Floor, sky and textures

// Below blocks and objects the floor is that of the tile to the west or east.
function floorOf(rows, own) {
  const isFloor = (character) => Object.hasOwn(own.floors, character);
  const tiles = rows.map((row) =>
    row
      .map((character, x) => {
        const beside = [character, row[x - 1] ?? '', row[x + 1] ?? ''].find(isFloor) ?? '.';
        return beside === '.' ? kFloorLetter : beside;
      })
      .join(''),
  );
  const seen = new Set(tiles.flatMap(signsOf));
  const used = Object.entries(own.floors)
    .map(([character, texture]) => [character === '.' ? kFloorLetter : character, texture])
    .filter(([letter]) => letter !== ' ' && seen.has(letter));
  const texture = own.floors[' '];
  const hasWater = [texture, ...used.map(([, other]) => other)].includes(kWater);
  return { texture, ...(hasWater && { water: kWater }), legend: Object.fromEntries(used), tiles };
}

function surroundingsOf(sky, hasColours) {
  const haze = kSkyColours.low;
  if (sky === null)
    return { sky: hasColours ? kSkyColours : { panorama: '../textures/sky-day.png' }, haze };
  if (typeof sky === 'object') return { sky, haze };
  if (kColour.test(sky)) return { sky: fullColour(sky), haze: fullColour(sky) };
  return { sky: { panorama: /\.png$/i.test(sky) ? sky : `../textures/${sky}.png` }, haze };
}

// A texture may be called `constructor`.
const entry = (table, name) => (Object.hasOwn(table, name) ? table[name] : undefined);

function texturesOf(blueprints, floor, own = {}, hasColours) {
  const ofBlocks = Object.values(blueprints).flatMap(({ faces: all = [] }) =>
    (typeof all === 'string' ? [all] : Object.values(all)).map((face) => face?.texture ?? face),
  );
  const names = [floor.texture, ...Object.values(floor.legend), ...ofBlocks];
  const fileOf = (name) =>
    entry(own, name) ??
    (kColour.test(name) || /\.png$/i.test(name)
      ? fullColour(name)
      : ((hasColours ? entry(kColours, name) : undefined) ??
        entry(kElsewhere, name) ??
        `../textures/${name}.png`));
  return {
    ...own,
    ...Object.fromEntries(
      [...new Set(names)]
        .filter((name) => typeof name === 'string')
        .map((name) => [name, fileOf(name)]),
    ),
  };
}
