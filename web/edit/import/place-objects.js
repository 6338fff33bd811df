// Turns the objects of a map into those of a scene: sprites, lamps, messages and starts, by the
// uses that the proposal gives their classes. What has no counterpart is noted, with its id.
//
//     const { objects, lamps, messages, starts } = placeObjects(map, grid, proposal, looks, ...);

import { quoted } from './import-error.js';
import { kMostMessage, kMostMessages } from './import-limits.js';
import { numberOf, textOf } from './properties.js';
import { kShippedSprites } from './shipped-sprites.js';

const kMostHeight = 64; // units, of an object
const kRim = 0.01; // units: what stands on the map's eastern edge is outside
const kLampHeight = 0.7; // units above the level's base
const kNear = 3; // tiles: how wide and deep is the place where somebody is heard
const kSaid = ['dialog', 'dialogue', 'text', 'message'];
const kTold = ['sprite', 'z', 'level', 'heading', 'direction', ...kSaid];
const kToldOfLamps = [...kTold, 'colour', 'color', 'strength', 'intensity', 'radius'];

export function placeObjects(map, grid, proposal, looks, notes, fault) {
  const classes = new Map(proposal.classes.map((row) => [row.name, row]));
  // `isLit`: an object has a lamp, for which the map needs baked light
  const placed = { objects: [], lamps: [], messages: [], starts: [], isLit: false };
  // What stands in a block would not be seen.
  const raised = ({ x, y }, wanted, place) => {
    const z = grid.standing(x, y, wanted);
    if (z !== wanted) notes.add(place, `it stands in a block, and so was put onto it, at ${z}`);
    return z;
  };
  const where = proposal.maps.length > 1 ? `map ${quoted(map.name)}, ` : '';
  for (const { kind, x, y, z, layer } of grid.sprites) {
    const { name, size, comment } = proposal.kinds[kind - 1];
    const place = `${where}layer ${quoted(layer)}, tile ${x - 0.5},${y - 0.5}`;
    const sprite = looks.sprite(kind);
    if (sprite === null) notes.add(place, 'no picture');
    else {
      const at = { x, y, z: raised({ x, y }, z, place) };
      placed.objects.push(objectOf({ sprite, ...at, size, comment: comment && name }));
    }
  }
  for (const object of map.objects) {
    const layer = proposal.objectLayers[object.layer];
    const { use = 'object', sprite = null } = classes.get(object.of) ?? {};
    const place = `${where}${placeOf(object, layer)}`;
    if (layer.use === 'leave out') continue;
    if (object.isHidden || use === 'leave out') {
      notes.add(place, object.isHidden ? 'hidden, and so left out' : 'left out');
      continue;
    }
    const at = placeWithin(object, map, grid.outside, place, notes);
    const all = { object, sprite, at, layer, place, placed, map, looks, notes, raised };
    if (at !== null) kPlacers[use](all);
  }
  if (placed.messages.length > kMostMessages)
    throw fault('', `${placed.messages.length} messages`, `at most ${kMostMessages} in a map`);
  return placed;
}

const kPlacers = {
  object: placeSprite,
  start: placeStart,
  lamp: placeLamp,
  message: placeMessage,
};

function placeOf({ id, name, class: kind, shape }, layer) {
  const title = [kind, name].filter((part) => part !== '').join(' ') || shape;
  return `layer ${quoted(layer.name)}, object ${id} ${quoted(title)}`;
}

// Null if it is left out.
function placeWithin({ x, y }, { width, depth }, outside, place, notes) {
  const [atX, atY] = [
    [x, width],
    [y, depth],
  ].map(([at, most]) => rounded(within(at || 0, 0, most - kRim)));
  if (x >= 0 && x < width && y >= 0 && y < depth) return { x: atX, y: atY };
  if (outside === 'move to edge') {
    notes.add(place, `outside the map, and so moved to its edge, ${atX},${atY}`);
    return { x: atX, y: atY };
  }
  notes.add(place, 'outside the map, and so left out');
  return null;
}

const rounded = (number) => Math.round(number * 1e4) / 1e4;
const within = (number, least, most) => Math.min(most, Math.max(least, number));
const propertiesOf = ({ properties }) => new Map(Object.entries(properties));

function heightOf(own, layer) {
  return within(numberOf(own, 'z') ?? numberOf(own, 'level') ?? layer.level, 0, 1000);
}

// In degrees from the east, or null. A word may be the name of a side.
function headingOf(object) {
  const own = propertiesOf(object);
  const word = String(own.get('heading') ?? own.get('direction') ?? '').toLowerCase();
  const sides = {
    east: 0,
    right: 0,
    south: 90,
    down: 90,
    west: 180,
    left: 180,
    north: 270,
    up: 270,
  };
  if (Object.hasOwn(sides, word)) return sides[word];
  const number = numberOf(own, 'heading') ?? numberOf(own, 'direction');
  if (number !== null) return number % 360;
  return object.rotation % 360 === 0 ? null : object.rotation % 360;
}

// What is kept for people and programs that read the scene.
function keptOf({ class: kind, name, properties }, told) {
  const rest = Object.entries(properties).filter(([key]) => !told.includes(key));
  return {
    comment: [kind, name].filter(Boolean).join(' '),
    data: rest.length === 0 ? null : Object.fromEntries(rest),
  };
}

function objectOf({ sprite, x, y, z, size, comment, data = null, heading = null, lamp = null }) {
  const sideOf = (side) => within(rounded(side) || 1, 0.01, kMostHeight);
  return {
    ...(comment && { comment }),
    ...(data !== null && { data }),
    sprite,
    x,
    y,
    ...(z > 0 && { z }),
    height: sideOf(size.height),
    ...(size.width !== undefined && { width: sideOf(size.width) }),
    ...(heading !== null && { heading }),
    ...(lamp !== null && { lamp }),
  };
}

// The property counts more than what the class is shown as; only it has the object's size.
function shippedOf({ object, sprite }) {
  const own = String(propertiesOf(object).get('sprite') ?? '');
  const isOwn = Object.hasOwn(kShippedSprites, own);
  const name = isOwn ? own : sprite;
  if (!Object.hasOwn(kShippedSprites, name ?? '')) return null;
  const { height } = kShippedSprites[name];
  return { name, size: isOwn && object.height > 0 ? object : { height } };
}

function placeSprite(all) {
  const { object, at, layer, place, placed, looks, notes, raised } = all;
  const { lamp = null, told = kTold } = all;
  const own = propertiesOf(object);
  const shipped = shippedOf(all);
  const sprite =
    shipped !== null
      ? looks.shippedSprite(shipped.name)
      : object.kind === 0
        ? null
        : looks.sprite(object.kind);
  if (sprite === null) {
    const reason =
      object.kind === 0
        ? `${object.shape === 'ellipse' ? 'an' : 'a'} ${object.shape} without a picture`
        : 'its picture is missing';
    const has = Object.keys(object.properties);
    notes.add(place, `${reason}${has.length === 0 ? '' : `; it has ${has.join(', ')}`}`);
    placeSaid(all);
    return;
  }
  if (object.rotation % 360 !== 0)
    notes.add(place, `its picture stands upright; its turn of ${object.rotation} is its heading`);
  placed.objects.push(
    objectOf({
      sprite,
      ...at,
      z: raised(at, heightOf(own, layer), place),
      size: shipped?.size ?? object,
      ...keptOf(object, told),
      heading: headingOf(object),
      lamp,
    }),
  );
  placeSaid(all);
}

// Who has something to say is heard around him.
function placeSaid(all) {
  const said = kSaid.map((name) => all.object.properties[name]).find(Boolean);
  if (said === undefined) return;
  const { width, height } = all.object;
  const near = { width: Math.max(kNear, width), height: Math.max(kNear, height) };
  addMessage(all, textOf(said), { ...near, kept: {} });
}

function placeStart({ object, at, layer, place, placed, notes }) {
  const z = heightOf(propertiesOf(object), layer);
  const { data } = keptOf(object, kTold);
  if (data !== null)
    notes.add(place, `its properties are left out: ${Object.keys(data).join(', ')}`);
  placed.starts.push({ ...at, z, heading: headingOf(object), place });
}

function placeLamp(all) {
  const { object, at, layer, place, placed, raised } = all;
  const own = propertiesOf(object);
  const colour = String(own.get('colour') ?? own.get('color') ?? '');
  const [, digits] = /^#?(?:[0-9a-f]{2})?([0-9a-f]{6})$/i.exec(colour) ?? [];
  const strength = numberOf(own, 'strength', 0, 16) ?? numberOf(own, 'intensity', 0, 16);
  const size = Math.max(object.width, object.height) / 2;
  const radius =
    numberOf(own, 'radius', 0.1, 16) ?? (object.shape === 'ellipse' && size > 0 ? size : null);
  const lamp = {
    ...(digits !== undefined && { colour: `#${digits.toLowerCase()}` }),
    ...(strength !== null && { strength }),
    ...(radius !== null && { radius: within(rounded(radius), 0.1, 16) }),
  };
  if (object.kind !== 0 || shippedOf(all) !== null) {
    placeSprite({ ...all, lamp, told: kToldOfLamps });
    placed.isLit = true;
    return;
  }
  const { comment, data } = keptOf(object, kToldOfLamps);
  const z = numberOf(own, 'z', 0, 1000) ?? within(heightOf(own, layer) + kLampHeight, 0, 1000);
  placed.lamps.push({
    ...(comment && { comment }),
    ...(data !== null && { data }),
    ...at,
    z: raised(at, z, place),
    ...lamp,
  });
}

function placeMessage(all) {
  const { object } = all;
  const said = kSaid.map((name) => object.properties[name]).find(Boolean);
  const { data } = keptOf(object, kTold);
  const kept = data === null ? {} : { data };
  addMessage(all, textOf(object.text || said || object.name), { ...object, kept });
}

function addMessage({ object, at, layer, place, placed, map, notes }, said, around) {
  const own = propertiesOf(object);
  const text = said.trim();
  if (text === '') {
    notes.add(place, 'a message without a text');
    return;
  }
  if ([...text].length > kMostMessage)
    notes.add(place, `its text is cut after ${kMostMessage} characters`);
  const [x, across] = tilesOf(at.x, around.width, map.width);
  const [y, down] = tilesOf(at.y, around.height, map.depth);
  const bottom = heightOf(own, layer);
  placed.messages.push({
    ...around.kept,
    text: [...text].slice(0, kMostMessage).join(''),
    x,
    y,
    width: across,
    depth: down,
    ...(bottom > 0 && { bottom }),
  });
}

// The tiles that a length around a place touches: the first, and how many.
function tilesOf(middle, length, most) {
  const first = within(Math.floor(middle - length / 2), 0, most - 1);
  const end = within(Math.ceil(middle + length / 2), first + 1, most);
  return [first, end - first];
}
