// The palette: the kinds of blocks of the map, the textures to paint with, or the things to put, to
// choose from. Keys 1 to 9 choose the first ones.
// Takes an editor and pictures; gives choices. Changes nothing but what is chosen.
//
//     const palette = new Palette(list, editor, pictures, { add() {} });
//     palette.digit(3);                       // chooses the third one

import { paintBlock, paintPart, paintWhole } from './block-icons.js';
import { kFinds } from './finds.js';
import { kLinkLooks } from './link-looks.js';
import { kindsOf } from './kinds.js';
import { pictureOf } from './files/shipped.js';
import { tableOf } from './names.js';
import { paintThing } from './thing-icons.js';
import { thing } from './tools/thing.js';

const kIcon = 44; // CSS pixels
const kAdd = {
  blocks: 'Add a block',
  textures: 'Add a texture',
  things: 'Add a thing',
  stamps: 'Save the selection as a stamp',
};

export class Palette {
  #list;
  #editor;
  #pictures;
  #actions;
  #shown = '';
  #isDue = false; // to be painted

  constructor(list, editor, pictures, actions) {
    this.#list = list;
    this.#editor = editor;
    this.#pictures = pictures;
    this.#actions = actions;
    editor.listen((what) => what === 'choice' && this.show());
    editor.scene.listen(({ isWhole }) => isWhole && this.show());
    pictures.listen(() => this.#paint());
    this.show();
  }

  // 'blocks', 'textures', 'things' or 'stamps'
  get #what() {
    const { name, hasThings, hasStamps } = this.#editor.tool;
    if (hasStamps) return 'stamps';
    return hasThings ? 'things' : name === 'paint' ? 'textures' : 'blocks';
  }

  get #entries() {
    const { scene, map } = this.#editor;
    switch (this.#what) {
      case 'textures':
        return Object.keys(tableOf(scene.value, 'textures')).map((name) => ({
          key: name,
          name,
          choice: { texture: name },
          paint: (icon) => paintBlock(icon, { faces: name }, this.#pictures),
        }));
      case 'things':
        return [
          { key: 'start', name: 'Start', choice: { thing: 'start' }, paint: paintKind('start') },
          { key: 'lamp', name: 'Lamp', choice: { thing: 'lamp' }, paint: paintKind('lamp') },
          {
            key: 'message',
            name: 'Message',
            choice: { thing: 'message' },
            paint: paintKind('message'),
          },
          { key: 'goal', name: 'Goal', choice: { thing: 'goal' }, paint: paintKind('goal') },
          ...kFinds.map(({ name, picture }) => ({
            key: `find ${name}`,
            name: `Find: ${name}`,
            title: `A ${name} to find, which may open a gate`,
            choice: { thing: { find: name } },
            paint: (icon) => {
              paintWhole(icon, this.#pictures.ofFile(picture.file, picture));
              paintStar(icon);
            },
          })),
          ...Object.keys(tableOf(scene.value, 'sprites')).map((name) => ({
            key: `sprite ${name}`,
            name,
            choice: { thing: { name, height: this.#usualHeight(name) } },
            paint: (icon) => paintWhole(icon, this.#pictures.spriteOf(name)),
          })),
        ];
      case 'stamps':
        return this.#actions.stamps().map(({ name, part }) => ({
          key: `stamp ${name}`,
          name,
          choice: () => this.#actions.useStamp({ name, part }),
          paint: (icon) => paintPart(icon, part),
        }));
      default:
        return kindsOf(scene, map).map(({ sign, name, blueprint }) => ({
          key: sign,
          name,
          title: `${name} (${sign})`,
          choice: { sign },
          said: blueprint,
          paint: (icon) => paintBlock(icon, blueprint, this.#pictures),
        }));
    }
  }

  digit(number) {
    const entry = this.#entries[number - 1];
    if (entry !== undefined) this.#choose(entry);
  }

  // The next or the previous one.
  move(by) {
    const entries = this.#entries;
    const index = entries.findIndex(({ key }) => key === this.#chosen);
    const entry = entries[(index + by + entries.length) % entries.length];
    if (entry !== undefined) this.#choose(entry);
  }

  get #chosen() {
    const { sign, texture, thing, brush } = this.#editor;
    if (this.#what === 'stamps') return `stamp ${brush?.name}`;
    if (this.#what === 'blocks') return sign;
    if (this.#what === 'textures') return texture;
    if (thing?.find !== undefined) return `find ${thing.find}`;
    return thing?.name === undefined ? thing : `sprite ${thing.name}`;
  }

  show() {
    const entries = this.#entries;
    const shown = JSON.stringify([this.#what, entries]);
    if (shown !== this.#shown) {
      this.#shown = shown;
      this.#list.replaceChildren(
        ...entries.map((entry, index) => this.#button(entry, index)),
        this.#adding(),
      );
      this.#paint();
    }
    for (const button of this.#list.querySelectorAll('button[data-key]')) {
      const isChosen = String(button.dataset.key === this.#chosen);
      if (button.getAttribute('aria-pressed') === isChosen) continue;
      button.setAttribute('aria-pressed', isChosen);
      if (isChosen === 'true') button.scrollIntoView({ block: 'nearest', inline: 'nearest' });
    }
  }

  // Things are put by the tool for them.
  #choose({ choice }) {
    const chosen = typeof choice === 'function' ? choice() : choice;
    this.#editor.choose(this.#what === 'things' ? { tool: thing, ...chosen } : chosen);
  }

  #button(entry, index) {
    const { key, name, title = name } = entry;
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'block';
    button.dataset.key = key;
    button.title = title;
    button.setAttribute('aria-label', name);
    const icon = document.createElement('canvas');
    icon.width = icon.height = kIcon * Math.ceil(devicePixelRatio);
    button.append(icon);
    if (index < 9) button.dataset.digit = String(index + 1);
    button.addEventListener('click', () => this.#choose(entry));
    return button;
  }

  #adding() {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'block add';
    const what = kAdd[this.#what];
    button.title = what;
    button.setAttribute('aria-label', what);
    button.textContent = '+';
    button.addEventListener('click', () => this.#actions.add(this.#what));
    return button;
  }

  // As other objects with that sprite have it, or else the shipped scenes.
  #usualHeight(name) {
    const { value } = this.#editor.scene;
    const { maps } = value;
    const heights = maps
      .flatMap(({ objects = [] }) => objects)
      .filter(({ sprite }) => sprite === name)
      .map(({ height }) => height);
    const picture = pictureOf(value, 'sprites', name);
    const file = picture.file ?? picture;
    return heights[heights.length >> 1] ?? this.#actions.heightOf(file) ?? 1;
  }

  // Once, before the next frame.
  #paint() {
    if (this.#isDue) return;
    this.#isDue = true;
    requestAnimationFrame(() => {
      this.#isDue = false;
      const buttons = this.#list.querySelectorAll('button[data-key]');
      this.#entries.forEach(({ paint }, index) => {
        const icon = buttons[index]?.querySelector('canvas');
        if (icon) paint(icon);
      });
    });
  }
}

const paintKind = (kind) => (icon) => {
  const context = icon.getContext('2d');
  context.clearRect(0, 0, icon.width, icon.height);
  paintThing(context, kind, icon.width);
};

// In the corner: one takes it along.
function paintStar(icon) {
  const context = icon.getContext('2d');
  context.setTransform(icon.width / 16, 0, 0, icon.height / 16, 0, 0);
  context.fillStyle = kLinkLooks.find.colour;
  context.fill(new Path2D('M2.5 0l1 1.7 1.8.8-1.8.8-1 1.7-1-1.7L-.3 2.5l1.8-.8z'));
  context.resetTransform();
}
