// The table of a map from elsewhere: a row for each layer, kind of tile and class of objects, with
// what it becomes. Takes a proposal (import/propose.js) and changes it by what is chosen.
//
//     const table = new ImportRows(place, shipped, () => ...);      // told after each choice
//     table.show(proposal);
//
// `shipped` lists the shipped pictures by group, as edit/pictures.json has them.

import {
  classUses,
  groupsOf,
  kindUses,
  kShippedSprites,
  lampsOf,
  layersOfKinds,
  layerUses,
  lightUses,
  objectLayerUses,
  outsideOf,
  outsideUses,
  seenAs,
  setKindUse,
  setLayerUse,
} from '../import/index.js';
import { element, numberField, select, words } from './controls.js';
import { KindIcons } from './kind-icons.js';

const kFirstKinds = 40; // that are listed before somebody asks for all
const kTexture = /^textures\/([a-z][a-z0-9-]*)\.png$/;
const kHeight = { min: 0, max: 1, step: 0.1 };

const counted = (count, one, many) => `${count} ${count === 1 ? one : many}`;
const spoken = (name) => name.replaceAll('-', ' ');

export class ImportRows {
  #place;
  #shipped;
  #isChanged;
  #proposal;
  #icons;
  #updates = []; // functions that show what the proposal says

  constructor(place, shipped, isChanged) {
    this.#place = place;
    this.#shipped = shipped;
    this.#isChanged = isChanged;
  }

  show(proposal) {
    this.#proposal = proposal;
    this.#updates = [];
    this.#icons = new KindIcons(proposal, () => this.#update());
    const { objectLayers, classes } = proposal;
    this.#place.replaceChildren(
      ...part('Layers', this.#layerRows()),
      ...part('Tiles', this.#kindRows()),
      ...part(
        'Layers of objects',
        objectLayers.map((layer) => this.#objectLayerRow(layer)),
      ),
      ...part('Objects', [
        ...classes.map((row) => this.#classRow(row)),
        ...(classes.length === 0 ? [] : [this.#lightRow()]),
        ...this.#outsideRow(),
      ]),
    );
    this.#update();
  }

  #update() {
    for (const update of this.#updates) update();
  }

  #changed() {
    this.#update();
    this.#isChanged();
  }

  // ---- Controls

  #add({ node, update }, isShown = () => true) {
    this.#updates.push(() => {
      node.hidden = !isShown();
      update();
    });
    return node;
  }

  #select(label, choices, get, set, isShown) {
    const choose = (value) => {
      set(value);
      this.#changed();
    };
    return this.#add(select(label, choices, get, choose), isShown);
  }

  #number(label, row, field, limits, isShown) {
    const set = (number) => {
      if (number !== null || field !== 'level') row[field] = number;
      this.#changed();
    };
    return this.#add(
      numberField(label, `of ${row.name}`, limits, () => row[field], set),
      isShown,
    );
  }

  // Of blocks, within their level; left out they are 0 and 1.
  #heights(row, isShown) {
    return [
      this.#number('From', row, 'bottom', { ...kHeight, placeholder: '0' }, isShown),
      this.#number('to', row, 'top', { ...kHeight, placeholder: '1' }, isShown),
    ];
  }

  #icon(paint, properties = {}) {
    const icon = element('canvas', { width: 40, height: 40, ...properties });
    icon.setAttribute('aria-hidden', 'true');
    this.#updates.push(() => paint(icon));
    return icon;
  }

  // ---- Layers

  #layerRows() {
    const { layers } = this.#proposal;
    return groupsOf(layers).flatMap(({ name, layers: numbers }) => {
      const rows = numbers.map((number) => this.#layerRow(layers[number], number));
      return name === '' ? rows : [this.#groupRow(name, numbers), ...rows];
    });
  }

  // Chooses for all layers of a group at once.
  #groupRow(name, numbers) {
    const members = numbers.map((number) => this.#proposal.layers[number]);
    const common = () => (members.every(({ use }) => use === members[0].use) ? members[0].use : '');
    const set = (use) => {
      if (use !== '') for (const layer of members) setLayerUse(this.#proposal, layer, use);
    };
    return element(
      'li',
      { className: 'group' },
      words(name, `a group of ${counted(members.length, 'layer', 'layers')}`),
      this.#select(
        `What all of ${name} becomes`,
        [['', 'Each by itself'], ...layerUses],
        common,
        set,
      ),
    );
  }

  #layerRow(layer, number) {
    const { name, tiles, look } = layer;
    const isUse = (...uses) => uses.includes(layer.use);
    return element(
      'li',
      {},
      this.#icon((icon) => this.#icons.paintLayer(icon, number), { className: 'layer' }),
      words(name.slice(name.lastIndexOf('/') + 1) || name, counted(tiles, 'tile', 'tiles')),
      this.#select(
        `What ${name} becomes`,
        layerUses,
        () => layer.use,
        (use) => setLayerUse(this.#proposal, layer, use),
      ),
      this.#number('Level', layer, 'level', { min: 0, max: 31, step: 1 }, () =>
        isUse('level', 'sprites'),
      ),
      this.#number('Height', layer, 'level', { min: 0.1, max: 1000, step: 0.5 }, () =>
        isUse('ceiling'),
      ),
      ...this.#heights(layer, () => isUse('level')),
      ...(look === null
        ? []
        : [element('span', { className: 'more' }, this.#lookOfLayer(layer, look))]),
    );
  }

  // Values of a grid may show the tiles that lie over them.
  #lookOfLayer(layer, look) {
    return this.#select(
      `What ${layer.name} shows`,
      [
        ['tiles', `Shows ${this.#proposal.layers[look].name}`],
        ['own', 'Shows what is chosen below'],
      ],
      () => (layer.look === null ? 'own' : 'tiles'),
      (choice) => (layer.look = choice === 'tiles' ? look : null),
      () => layer.use === 'level',
    );
  }

  // ---- Kinds of tiles

  #kindRows() {
    const layersOf = layersOfKinds(this.#proposal);
    const kinds = this.#proposal.kinds
      .map((kind, number) => ({ kind, number }))
      .filter(({ kind }) => kind.count > 0)
      .sort((one, other) => other.kind.count - one.kind.count);
    const row = ({ kind, number }) => this.#kindRow(kind, number, layersOf[number]);
    const more = kinds.slice(kFirstKinds);
    const rows = kinds.slice(0, kFirstKinds).map(row);
    if (more.length === 0) return rows;
    const button = element('button', { type: 'button' }, `Show ${more.length} more`);
    const last = element('li', {}, button);
    button.addEventListener('click', () => {
      const others = more.map(row);
      last.replaceWith(...others);
      this.#update();
      others[0].querySelector('select').focus();
    });
    return [...rows, last];
  }

  #kindRow(kind, number, layers) {
    const { name, count } = kind;
    const isSeenAs = (...uses) => seenAs(kind, layers).some((use) => uses.includes(use));
    return element(
      'li',
      {},
      this.#icon((icon) => this.#icons.paint(icon, number)),
      words(name, counted(count, 'time', 'times')),
      this.#select(
        `What ${name} becomes`,
        () => kindUses(kind, layers),
        () => kind.use,
        (use) => setKindUse(kind, use),
      ),
      this.#look(kind, number, () => isSeenAs('block', 'floor', 'ceiling')),
      ...this.#heights(kind, () => isSeenAs('block')),
    );
  }

  // Its own picture, a shipped one, or a colour.
  #look(kind, number, isShown) {
    const isColour = () => kind.show.startsWith('#');
    const picture = kind.parts.length === 0 ? [] : [['picture', 'Its own picture']];
    const choose = this.#select(
      `What ${kind.name} looks like`,
      [...picture, ['#', 'A plain colour'], ...this.#shippedTextures()],
      () => (isColour() ? '#' : kind.show),
      (show) => (kind.show = show === '#' ? this.#icons.meanOf(number) : show),
      isShown,
    );
    const colour = element('input', { type: 'color' });
    colour.setAttribute('aria-label', `Colour of ${kind.name}`);
    colour.addEventListener('input', () => {
      kind.show = colour.value;
      this.#changed();
    });
    const update = () => isColour() && (colour.value = kind.show);
    const own = this.#add({ node: colour, update }, () => isShown() && isColour());
    return element('span', { className: 'look' }, choose, own);
  }

  // Those that are no sheets of frames.
  #shippedTextures() {
    return this.#shipped
      .map(({ group, pictures }) => [
        group,
        pictures
          .map(({ file }) => kTexture.exec(file)?.[1])
          .filter((name) => name !== undefined)
          .map((name) => [name, spoken(name)]),
      ])
      .filter(([, names]) => names.length > 0);
  }

  // ---- Objects

  #objectLayerRow(layer) {
    return element(
      'li',
      {},
      words(layer.name, ''),
      this.#select(
        `What becomes of ${layer.name}`,
        objectLayerUses,
        () => layer.use,
        (use) => (layer.use = use),
      ),
      this.#number(
        'Level',
        layer,
        'level',
        { min: 0, max: 31, step: 1 },
        () => layer.use === 'take',
      ),
    );
  }

  #classRow(row) {
    const { name, count } = row;
    const hasPicture = this.#proposal.maps.some(({ objects }) =>
      objects.some(({ of, kind }) => of === name && kind !== 0),
    );
    return element(
      'li',
      {},
      words(name, counted(count, 'object', 'objects')),
      this.#select(
        `What ${name} becomes`,
        classUses,
        () => row.use,
        (use) => (row.use = use),
      ),
      this.#select(
        `What ${name} looks like`,
        [
          ['', hasPicture ? 'Its own picture' : 'No picture'],
          ...Object.keys(kShippedSprites).map((sprite) => [sprite, spoken(sprite)]),
        ],
        () => row.sprite ?? '',
        (sprite) => (row.sprite = sprite === '' ? null : sprite),
        () => ['object', 'lamp'].includes(row.use),
      ),
    );
  }

  // How dark it is around lamps, if there are some.
  #lightRow() {
    const count = element('span', { className: 'soft' });
    const node = element(
      'li',
      {},
      element('span', { className: 'words' }, element('b', {}, 'Light of the world'), count),
      this.#select(
        'Light of the world',
        lightUses,
        () => this.#proposal.light,
        (light) => (this.#proposal.light = light),
      ),
    );
    const update = () => (count.textContent = counted(lampsOf(this.#proposal), 'lamp', 'lamps'));
    return this.#add({ node, update }, () => lampsOf(this.#proposal) > 0);
  }

  #outsideRow() {
    const count = outsideOf(this.#proposal);
    if (count === 0) return [];
    return [
      element(
        'li',
        {},
        words('Beside the map', counted(count, 'object', 'objects')),
        this.#select(
          'Objects beside the map',
          outsideUses,
          () => this.#proposal.outside,
          (use) => (this.#proposal.outside = use),
        ),
      ),
    ];
  }
}

function part(title, rows) {
  return rows.length === 0 ? [] : [element('h3', {}, title), element('ul', {}, ...rows)];
}
