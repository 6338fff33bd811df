// The dialog that adds a kind of block, a texture or a kind of thing: the shipped pictures by
// group, or a colour. Takes an editor; gives changes to the history, and the choice.
//
//     const adding = new Adding(dialog, editor, pictures, { readShipped, ownPictures });
//     adding.block();                     // a new kind of block, then chosen
//     adding.texture((name) => ...);      // a texture, new or known
//     adding.sprite();                    // a sprite for things, then chosen

import { paintWhole } from './block-icons.js';
import { freeName, kindFor } from './kinds.js';

const kFit = { textures: /^(textures|see-through|sheets)\//, sprites: /^sprites\// };

export class Adding {
  #dialog;
  #editor;
  #pictures;
  #readShipped;
  #ownPictures;
  #ownPart = document.createElement('section');
  #then = null;
  #what = ''; // 'textures' or 'sprites', as the dialog shows them

  constructor(dialog, editor, pictures, { readShipped, ownPictures }) {
    this.#dialog = dialog;
    this.#editor = editor;
    this.#pictures = pictures;
    this.#readShipped = readShipped;
    this.#ownPictures = ownPictures;
    pictures.listen(() => dialog.open && this.#showOwn());
  }

  block() {
    this.#open('Add a block', 'textures', (name) => {
      const { scene, map, history } = this.#editor;
      const { sign, changes } = kindFor(scene, map, name, { faces: name });
      history.do('Add a block', changes);
      this.#editor.choose({ sign });
    });
  }

  texture(then) {
    this.#open('Choose a texture', 'textures', then);
  }

  sprite() {
    this.#open('Add a thing', 'sprites', (name, { height = 1 }) =>
      this.#editor.choose({ thing: { name, height } }),
    );
  }

  async #open(title, what, then) {
    this.#then = then;
    this.#dialog.querySelector('h2').textContent = title;
    this.#dialog.showModal();
    const isThere = this.#what === what;
    this.#what = what;
    this.#showOwn();
    if (isThere) return;
    const body = this.#dialog.querySelector('.body');
    body.replaceChildren(this.#ownPart);
    for (const { group, pictures } of await this.#readShipped()) {
      const fit = pictures.filter(({ file }) => kFit[what].test(file));
      if (fit.length === 0) continue;
      const title = document.createElement('h3');
      title.textContent = group;
      const list = document.createElement('div');
      list.className = 'pictures';
      list.append(...fit.map((picture) => this.#button(picture)));
      body.append(title, list);
    }
  }

  // What the visitor has brought.
  #showOwn() {
    const input = document.createElement('input');
    Object.assign(input, { type: 'file', accept: 'image/*', multiple: true, hidden: true });
    input.addEventListener('change', () => this.#bring([...input.files]));
    const bring = document.createElement('button');
    bring.type = 'button';
    bring.textContent = 'A picture of your own';
    bring.addEventListener('click', () => input.click());
    const line = document.createElement('p');
    line.className = 'row';
    line.append(...(this.#what === 'textures' ? this.#colours() : []), bring, input);
    const list = document.createElement('div');
    list.className = 'pictures';
    list.append(...this.#ownPictures.list(this.#what).map((one) => this.#ownCell(one)));
    this.#ownPart.replaceChildren(line, list);
  }

  async #bring(files) {
    const name = await this.#ownPictures.add(files, this.#what);
    if (name !== null) this.#use(name);
  }

  #ownCell({ name, file, isUsed }) {
    const cell = document.createElement('div');
    const button = document.createElement('button');
    button.type = 'button';
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = 48;
    paintWhole(canvas, this.#pictures.ofFile(file));
    const label = document.createElement('span');
    label.textContent = name;
    button.append(canvas, label);
    button.addEventListener('click', () => this.#use(name));
    cell.append(button);
    if (isUsed) return cell;
    const remove = document.createElement('button');
    remove.type = 'button';
    remove.className = 'quiet remove';
    remove.textContent = 'Remove';
    remove.title = `Remove ${name}, which is used nowhere`;
    remove.addEventListener('click', () => {
      this.#ownPictures.remove(file);
      this.#showOwn();
    });
    cell.append(remove);
    return cell;
  }

  #button(picture) {
    const { file, frames, rate, views } = picture;
    const said = JSON.parse(JSON.stringify({ frames, rate, views })); // without what is left out
    const name = file.replace(/^.*\//, '').replace('.png', '');
    const button = document.createElement('button');
    button.type = 'button';
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = 48;
    const label = document.createElement('span');
    label.textContent = name.replaceAll('-', ' ');
    button.append(canvas, label);
    const paint = () => paintWhole(canvas, this.#pictures.ofFile(`../${file}`, said));
    paint();
    this.#pictures.listen(paint);
    const value = Object.keys(said).length === 0 ? `../${file}` : { file: `../${file}`, ...said };
    button.addEventListener('click', () => this.#choose(name, value, picture));
    return button;
  }

  #colours() {
    const input = document.createElement('input');
    input.type = 'color';
    input.value = '#c0603a';
    input.setAttribute('aria-label', 'Colour');
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = 'A plain colour';
    button.addEventListener('click', () => this.#choose(input.value, input.value));
    return [input, button];
  }

  // The texture of the scene that is that picture, or a new one; so for sprites.
  #choose(wanted, value, picture = {}) {
    const { scene, history } = this.#editor;
    const known = scene.value[this.#what] ?? {};
    const said = JSON.stringify(value);
    let name = Object.keys(known).find((other) => JSON.stringify(known[other]) === said);
    if (name === undefined) {
      name = freeName(wanted, known);
      const label = this.#what === 'textures' ? 'Add a texture' : 'Add a sprite';
      history.do(label, [{ path: [this.#what, name], value }]);
    }
    this.#use(name, picture);
  }

  #use(name, picture = {}) {
    this.#dialog.close();
    this.#then?.(name, picture);
  }
}
