// Shows the chosen kind of block: its picture, its name, its faces and heights, to be changed for
// all blocks of that kind. Takes an editor and pictures; gives changes to the history.
//
//     new KindPanel(section, editor, pictures, { chooseTexture(then) {} });

import { paintBlock } from './block-icons.js';
import { kindOf } from './kinds.js';
import { extentOf, kFaces, textureOf, withFace, withHeight } from './shapes.js';

const kIcon = 64; // CSS pixels

export class KindPanel {
  #section;
  #editor;
  #pictures;
  #actions;

  constructor(section, editor, pictures, actions) {
    this.#section = section;
    this.#editor = editor;
    this.#pictures = pictures;
    this.#actions = actions;
    editor.listen((what) => what === 'choice' && this.show());
    editor.scene.listen(({ isWhole }) => isWhole && this.show());
    pictures.listen(() => this.show());
    this.show();
  }

  show() {
    const { scene, map, sign } = this.#editor;
    const kind = kindOf(scene, map, sign);
    this.#section.hidden = kind === null;
    if (kind === null) return;
    const focused = document.activeElement;
    if (this.#section.contains(focused) && focused.matches('input')) return;
    this.#section.replaceChildren(this.#head(kind), ...this.#heights(kind), this.#faces(kind));
  }

  #set(label, kind, blueprint) {
    if (blueprint === null) return;
    this.#editor.history.do(label, [{ path: ['blueprints', kind.name], value: blueprint }]);
  }

  #head({ name, sign, blueprint }) {
    const header = document.createElement('header');
    const icon = document.createElement('canvas');
    icon.width = icon.height = kIcon * Math.ceil(devicePixelRatio);
    paintBlock(icon, blueprint, this.#pictures);
    const title = document.createElement('h2');
    title.textContent = name;
    const about = document.createElement('p');
    about.className = 'soft';
    about.textContent = `“${sign}” in the rows`;
    const words = document.createElement('div');
    words.append(title, about);
    header.append(icon, words);
    return header;
  }

  #heights(kind) {
    const { low, high } = extentOf(kind.blueprint);
    const isSlope = [kind.blueprint.top, kind.blueprint.bottom].some(Array.isArray);
    const field = (label, edge, value) => {
      const line = document.createElement('p');
      line.className = 'field';
      const input = document.createElement('input');
      Object.assign(input, {
        type: 'number',
        min: 0,
        max: 1,
        step: 0.05,
        value,
        disabled: isSlope,
      });
      input.id = `kind-${edge}`;
      input.addEventListener('change', () => {
        const shaped = withHeight(kind.blueprint, edge, Number(input.value));
        if (shaped === null) input.value = value;
        else this.#set('Shape', kind, shaped);
      });
      const name = document.createElement('label');
      name.htmlFor = input.id;
      name.textContent = label;
      line.append(name, input);
      return line;
    };
    return [field('Top', 'top', high), field('Bottom', 'bottom', low)];
  }

  #faces(kind) {
    const list = document.createElement('div');
    list.className = 'faces';
    for (const face of kFaces) {
      const button = document.createElement('button');
      button.type = 'button';
      const name = textureOf(kind.blueprint, face);
      const picture = document.createElement('canvas');
      picture.width = picture.height = 48;
      const image = name === null ? null : this.#pictures.imageOf(name);
      const context = picture.getContext('2d');
      context.imageSmoothingEnabled = false;
      if (image !== null) context.drawImage(image, 0, 0, 48, 48);
      button.title = `${face}: ${name ?? 'nothing'}`;
      button.append(picture, face);
      button.addEventListener('click', () =>
        this.#actions.chooseTexture((texture) =>
          this.#set('Paint', kind, withFace(kind.blueprint, face, texture)),
        ),
      );
      list.append(button);
    }
    return list;
  }
}
