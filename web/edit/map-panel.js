// The map's own part of the panel: its size and its levels, new maps and their removal.
// What would be lost is told first. Takes an editor; gives changes to the history.
//
//     const maps = new MapPanel(place, editor, { moved({ x, y, z }) {} });
//     maps.show();                 // after another choice

import { kMostLevels, sizeOf } from './cells.js';
import { differences } from './differences.js';
import {
  kMostTiles,
  lossesOf,
  resized,
  withLevel,
  withMap,
  withoutLevel,
  withoutMap,
} from './map-size.js';
import { freeName } from './kinds.js';
import { namesToChoose } from './files/shipped.js';
import { ask, askWhether } from './small-dialogs.js';

const kAnchors = ['north-west', 'north', 'north-east', 'west', 'middle', 'east'].concat([
  'south-west',
  'south',
  'south-east',
]);
const kUsualSide = 24; // tiles of a new map

export class MapPanel {
  #editor;
  #buttons = {};
  #moved;

  // `moved`: what stood at the eye is elsewhere now, as {x, y, z}.
  constructor(place, editor, { moved }) {
    this.#editor = editor;
    this.#moved = moved;
    const button = (name, label, about, act) => {
      const made = document.createElement('button');
      made.type = 'button';
      made.textContent = label;
      made.title = about;
      made.addEventListener('click', act);
      this.#buttons[name] = made;
      return made;
    };
    place.append(
      row(
        button('size', 'Size', 'Change the size of this map', () => this.#size()),
        button('add', 'New map', 'Add a map to the world', () => this.#add()),
        button('remove', 'Remove', 'Remove this map', () => this.#remove()),
      ),
      row(
        button('insert', '', 'Put in an empty level there; Page up and Page down choose it', () =>
          this.#insert(),
        ),
        button('take', '', 'Take that level out; Page up and Page down choose it', () =>
          this.#take(),
        ),
      ),
    );
    editor.scene.listen(({ isWhole }) => isWhole && this.show());
    this.show();
  }

  show() {
    const { scene, map, level } = this.#editor;
    const { maps } = scene.value;
    if (maps[map] === undefined) return;
    const { levels } = sizeOf(scene, map);
    const { size, remove, insert, take } = this.#buttons;
    size.disabled = scene.mistake !== null;
    remove.disabled = maps.length < 2;
    insert.textContent = `Insert level ${level}`;
    insert.disabled = levels >= kMostLevels || level > levels;
    take.textContent = `Take out level ${level}`;
    take.disabled = level >= levels || levels < 2;
  }

  #do(label, next, by = null) {
    const { scene, history } = this.#editor;
    history.do(label, differences(scene.value, next, []));
    if (by !== null) this.#moved({ x: 0, y: 0, z: 0, ...by });
  }

  async #size() {
    const { scene, map } = this.#editor;
    const size = sizeOf(scene, map);
    const [width, depth] = [numberField(size.width), numberField(size.depth)];
    const anchors = document.createElement('fieldset');
    anchors.className = 'anchors';
    const legend = document.createElement('legend');
    legend.textContent = 'What stands stays at the';
    anchors.append(legend);
    for (const anchor of kAnchors) {
      const input = document.createElement('input');
      Object.assign(input, { type: 'radio', name: 'anchor', value: anchor });
      input.checked = anchor === 'north-west';
      input.title = anchor;
      input.setAttribute('aria-label', anchor);
      anchors.append(input);
    }
    const told = document.createElement('p');
    told.className = 'soft';
    told.setAttribute('role', 'status');
    const sides = () => {
      const { value: anchor } = anchors.querySelector(':checked');
      const more = [width.valueAsNumber - size.width, depth.valueAsNumber - size.depth];
      const [west, east] = shares(more[0], anchor, 'west', 'east');
      const [north, south] = shares(more[1], anchor, 'north', 'south');
      return { west, east, north, south };
    };
    const next = () => resized(scene.value, map, sides());
    const isGood = () => width.checkValidity() && depth.checkValidity();
    const tell = () => {
      const losses = isGood() ? lossesOf(scene.value, next()) : [];
      told.textContent =
        losses.length === 0 ? 'Nothing is lost.' : `This removes ${listed(losses)}.`;
    };
    for (const input of [width, depth, anchors]) input.addEventListener('input', tell);
    tell();
    const parts = [
      field('Width, west to east', width),
      field('Depth, north to south', depth),
      anchors,
      told,
    ];
    if (!(await ask('Size of the map', parts, 'Change')) || !isGood()) return;
    const { west, north } = sides();
    this.#do('Size', next(), { x: west, y: north });
    this.#editor.choose({ selection: null });
  }

  async #add() {
    const { scene, map } = this.#editor;
    const taken = Object.fromEntries(scene.value.maps.map(({ name }) => [name, true]));
    const name = document.createElement('input');
    Object.assign(name, { value: freeName('map', taken), maxLength: 100, required: true });
    const check = () =>
      name.setCustomValidity(Object.hasOwn(taken, name.value.trim()) ? 'A map has this name.' : '');
    name.addEventListener('input', check);
    const [width, depth] = [numberField(kUsualSide), numberField(kUsualSide)];
    const floor = document.createElement('select');
    floor.append(...namesToChoose(scene.value, 'textures').map((one) => new Option(one)));
    const present = scene.value.maps[map].floor;
    floor.value = typeof present === 'string' ? present : (present?.texture ?? '');
    const parts = [
      field('Name', name),
      field('Width, west to east', width),
      field('Depth, north to south', depth),
      field('Floor', floor),
    ];
    if (!(await ask('New map', parts, 'Add'))) return;
    const wanted = {
      name: name.value.trim(),
      width: width.valueAsNumber,
      depth: depth.valueAsNumber,
      floor: floor.value,
    };
    this.#do('Add a map', withMap(scene.value, wanted, map));
    this.#go(scene.value.maps.length - 1);
  }

  async #remove() {
    const { scene, map } = this.#editor;
    const { maps, start } = scene.value;
    const next = withoutMap(scene.value, map);
    const told = lossesOf(scene.value, next);
    const lines = [
      told.length === 0 ? 'The map is empty.' : `This removes ${listed(told)}, here and elsewhere.`,
    ];
    if ((start?.map ?? maps[0].name) === maps[map].name)
      lines.push(`The start comes to the middle of “${next.start?.map}”.`);
    if (!(await askWhether(`Remove the map “${maps[map].name}”?`, lines, 'Remove'))) return;
    this.#do('Remove the map', next);
    this.#go(Math.max(0, map - 1));
  }

  #insert() {
    const { scene, map, level } = this.#editor;
    this.#do('Insert a level', withLevel(scene.value, map, level), {});
    this.#editor.choose({ selection: null });
  }

  async #take() {
    const { scene, map, level } = this.#editor;
    const next = withoutLevel(scene.value, map, level);
    const losses = lossesOf(scene.value, next);
    const isSure =
      losses.length === 0 ||
      (await askWhether(
        `Take out level ${level}?`,
        [`This removes ${listed(losses)}.`],
        'Take out',
      ));
    if (!isSure) return;
    this.#do('Take out a level', next, {});
    this.#editor.choose({ selection: null });
  }

  #go(map) {
    this.#editor.choose({ map, level: 0, selection: null });
    const list = document.getElementById('map');
    list.dispatchEvent(new Event('change'));
  }
}

const listed = (words) =>
  words.length < 2 ? words.join('') : `${words.slice(0, -1).join(', ')} and ${words.at(-1)}`;

// What is added at either end of an axis, so that what stands stays at the anchor.
function shares(more, anchor, first, last) {
  if (anchor.includes(first)) return [0, more];
  if (anchor.includes(last)) return [more, 0];
  const half = Math.trunc(more / 2);
  return [half, more - half];
}

function numberField(value) {
  const input = document.createElement('input');
  Object.assign(input, { type: 'number', min: 1, max: kMostTiles, step: 1, required: true });
  input.value = String(Math.max(1, value));
  return input;
}

let fields = 0;
function field(text, input) {
  const line = document.createElement('p');
  line.className = 'field';
  const label = document.createElement('label');
  fields += 1;
  input.id = `map-field-${fields}`;
  label.htmlFor = input.id;
  label.textContent = text;
  line.append(label, input);
  return line;
}

function row(...parts) {
  const line = document.createElement('p');
  line.className = 'row map-row';
  line.append(...parts);
  return line;
}
