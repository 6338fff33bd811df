// A form for any value of the scene, made from the schema: each key with its words, range and what
// counts if it is left out. What a form cannot show is edited in other views.
// Takes a path; gives changes to the history. Knows no tool.
//
//     const form = new SchemaForm(parent, editor, schema, { leaveOut: ['levels'] });
//     form.show(['maps', 0]);        // that value; again after each change
//     form.show(null);

import { keyed, namedChange, namesOf, renameChange } from '../names.js';
import { namesToChoose } from '../files/shipped.js';
import { valueAt } from '../things.js';
import { kindOfValue } from './schema.js';

const kNever = new Set(['$schema', 'levels', 'tiles']); // rows are drawn
const kLast = ['comment', 'data'];
const kColour = /^#[0-9a-f]{6}$/i;
const kMostRows = 8; // of a text
const kRow = 30; // characters in a row of it
const kSummary = 40; // characters of a value beside its title
const kNoMeaning = 'Point at a line to read what it means.';
let ids = 0;

export class SchemaForm {
  #parent;
  #editor;
  #schema;
  #leaveOut;
  #open = new Set(); // paths, as texts, of parts that are open
  #path = null;
  #isLeft = false; // the field that changes has no longer the focus
  #isPressed = false; // the pointer is
  #isDue = false; // to be shown anew
  #about = document.createElement('p'); // what the line means that is pointed at or focused

  constructor(parent, editor, schema, { leaveOut = [] } = {}) {
    this.#parent = parent;
    this.#editor = editor;
    this.#schema = schema;
    this.#leaveOut = new Set([...kNever, ...leaveOut]);
    editor.scene.listen(({ isWhole }) => isWhole && this.#renew());
    parent.addEventListener('pointerdown', () => (this.#isPressed = true));
    for (const type of ['pointerup', 'pointercancel'])
      addEventListener(type, () => {
        this.#isPressed = false;
        setTimeout(() => this.#catchUp());
      });
    this.#about.className = 'meaning';
    this.#about.textContent = kNoMeaning;
    parent.after(this.#about);
    for (const type of ['pointerover', 'focusin'])
      parent.addEventListener(type, ({ target }) => this.#explain(target));
    for (const type of ['pointerleave', 'focusout'])
      parent.addEventListener(type, () => this.#explain(document.activeElement));
  }

  show(path) {
    this.#path = path;
    this.#isDue = false;
    if (this.#parent.closest('[hidden]') !== null) return; // in another tab
    const value = path === null ? undefined : valueAt(this.#editor.scene.value, path);
    if (value === undefined) {
      this.#parent.replaceChildren();
      return;
    }
    const active = this.#parent.contains(document.activeElement) ? document.activeElement : null;
    const caret = active?.selectionStart ?? null; // null: of what is no text
    const end = active?.selectionEnd;
    const name = keyed(path) ? [this.#renamer(path)] : [];
    this.#parent.replaceChildren(...name, ...this.#membersOf(path, value));
    if (active?.dataset.path === undefined) return;
    const same = this.#parent.querySelector(`[data-path="${CSS.escape(active.dataset.path)}"]`);
    same?.focus();
    if (caret !== null) same?.setSelectionRange?.(caret, end);
  }

  // A field that somebody leaves changes the form only when its next part has the focus, or is
  // clicked: it must not go meanwhile.
  #renew() {
    if (!this.#isLeft) {
      this.show(this.#path);
      return;
    }
    this.#isDue = true;
    setTimeout(() => this.#catchUp());
  }

  #catchUp() {
    if (this.#isDue && !this.#isPressed) this.show(this.#path);
  }

  #explain(target) {
    const line = this.#parent.contains(target) ? target.closest('[data-about]') : null;
    this.#about.textContent = line?.dataset.about ?? kNoMeaning;
  }

  // What refers to a name goes with it. Else words say why that cannot be, and all stays.
  #set(path, value) {
    const key = String(path.findLast((part) => typeof part === 'string') ?? 'scene');
    this.#do(`Change ${key}`, namedChange(this.#editor.scene, path, value), `form ${path}`);
  }

  #do(label, { changes, words }, key) {
    if (words === undefined) {
      this.#editor.history.do(label, changes, key);
      return;
    }
    this.#editor.say(words);
    this.show(this.#path);
  }

  #names(what) {
    const { value } = this.#editor.scene;
    const isPicture = what === 'textures' || what === 'sprites';
    return isPicture ? namesToChoose(value, what) : namesOf(value, what);
  }

  // A line for each key that an object has or may have, or each element of a list.
  #membersOf(path, value) {
    const said = this.#schema.at(path);
    if (said === undefined) return [];
    if (Array.isArray(value)) {
      const { item } = kindOfValue(said.kinds, value) ?? {};
      return [
        ...value.map((_, index) => this.#line([...path, index], item, `${index + 1}`)),
        this.#adder(path, value.length, item),
      ];
    }
    const kind = kindOfValue(said.kinds, value);
    if (kind === undefined) return [];
    const keys = new Set([...kind.keys.keys(), ...Object.keys(value)]);
    for (const key of kLast) if (keys.delete(key)) keys.add(key);
    const lines = [...keys]
      .filter((key) => !this.#leaveOut.has(key))
      .map((key) =>
        this.#line([...path, key], kind.keys.get(key) ?? kind.rest, key, kind.always.includes(key)),
      );
    return kind.rest === undefined ? lines : [...lines, this.#namer(path, kind.rest)];
  }

  #line(path, node, key, isNeeded = false) {
    const value = valueAt(this.#editor.scene.value, path);
    const said =
      node === undefined ? { title: key, about: '', kinds: [] } : this.#schema.of(node, key);
    const kind = value === undefined ? said.kinds[0] : kindOfValue(said.kinds, value);
    const isLarge =
      kind?.type === 'object' || (kind?.type === 'list' && !isPlainList(this.#schema, kind));
    return isLarge || kind === undefined
      ? this.#part(path, said, kind, value, { node, key, isNeeded })
      : this.#field(path, said, kind, value, { key, isNeeded });
  }

  // ---- Lines with a field

  #field(path, said, kind, value, { key, isNeeded }) {
    const line = document.createElement('p');
    line.className = 'field';
    const label = document.createElement('label');
    label.textContent = titleOf(said, key);
    explain(line, said);
    const field = this.#control(path, said, kind, value, isNeeded);
    field.id = `form-${(ids += 1)}`;
    field.dataset.path = String(path);
    label.htmlFor = field.id;
    if (value === undefined) line.classList.add('unset');
    if (keyed(path)) {
      field.setAttribute('aria-label', `${key}: value`);
      line.append(this.#nameInput(path), field);
    } else line.append(label, field);
    if (field.tagName === 'TEXTAREA') line.classList.add('long');
    if (kind.isColour || kColour.test(value)) line.append(this.#swatch(path, field));
    const others = said.kinds.filter((other) => other !== kind && other.type !== 'text');
    const richer = others.find(({ type }) => type === 'object');
    if (richer !== undefined) line.append(this.#richer(path, richer, value));
    return line;
  }

  // What is needed can be changed, but not cleared.
  #control(path, said, kind, value, isNeeded) {
    const { fallback } = said;
    if (kind.type === 'boolean' && fallback !== undefined) {
      const box = document.createElement('input');
      box.type = 'checkbox';
      box.checked = value ?? fallback;
      box.addEventListener('change', () =>
        this.#set(path, box.checked === fallback ? undefined : box.checked),
      );
      return box;
    }
    if (kind.type === 'boolean' || kind.choices) {
      const choices = kind.choices ?? [true, false];
      const select = document.createElement('select');
      const words = (choice) =>
        choice === true ? 'yes' : choice === false ? 'no' : String(choice);
      const usual = new Option(fallback === undefined ? '–' : `${words(fallback)} (usual)`, '');
      select.append(
        ...(isNeeded && value !== undefined ? [] : [usual]),
        ...choices.map((choice, index) => new Option(words(choice), index)),
      );
      select.value = value === undefined ? '' : String(choices.indexOf(value));
      select.addEventListener('change', () =>
        this.#set(path, select.value === '' ? undefined : choices[Number(select.value)]),
      );
      return select;
    }
    const isLong = kind.isLong === true;
    const input = document.createElement(isLong ? 'textarea' : 'input');
    const isNumber = kind.type === 'number' || kind.type === 'integer';
    if (isNumber) {
      input.type = 'number';
      input.step = kind.type === 'integer' ? 1 : 'any';
      if (Number.isFinite(kind.least)) input.min = kind.least;
      if (Number.isFinite(kind.most)) input.max = kind.most;
    } else if (kind.type === 'text') {
      if (kind.pattern) input.pattern = kind.pattern.replace(/^\^|\$$/g, '');
      if (kind.names) input.setAttribute('list', this.#listOf(kind.names));
    }
    input.placeholder = fallback === undefined ? '' : textOf(fallback);
    input.value = value === undefined ? '' : textOf(value);
    input.spellcheck = isLong;
    if (isLong) input.rows = Math.min(kMostRows, rowsOf(input.value));
    const isList = kind.type === 'list';
    input.required = isNeeded && !isList;
    input.addEventListener('input', () => input.setCustomValidity(''));
    input.addEventListener('change', () => {
      this.#isLeft = document.activeElement !== input;
      take();
      this.#isLeft = false;
    });
    const take = () => {
      if (input.value === '' && !isNeeded) {
        this.#set(path, undefined);
        return;
      }
      const list = isList ? readList(this.#schema, kind, input.value) : [];
      if (list.some(Number.isNaN))
        input.setCustomValidity(`Found "${input.value}", expected numbers with commas between.`);
      if (!input.reportValidity()) return;
      this.#set(path, isList ? list : isNumber ? Number(input.value) : input.value);
    };
    return input;
  }

  // Chooses a colour for the field beside it.
  #swatch(path, field) {
    const swatch = document.createElement('input');
    swatch.type = 'color';
    swatch.value = [field.value, field.placeholder].find((text) => kColour.test(text)) ?? '#000000';
    swatch.title = 'Choose a colour';
    swatch.setAttribute('aria-label', 'Choose a colour');
    swatch.addEventListener('change', () => this.#set(path, swatch.value));
    return swatch;
  }

  // A list of the scene's names, to choose from.
  #listOf(what) {
    const id = `names-${what}`;
    let list = document.getElementById(id);
    if (list === null) {
      list = document.createElement('datalist');
      list.id = id;
      document.body.append(list);
    }
    const names = this.#names(what);
    const listed = [...list.options].map(({ value }) => value);
    if (JSON.stringify(names) !== JSON.stringify(listed))
      list.replaceChildren(...names.map((name) => new Option(name)));
    return id;
  }

  // From a plain value to one with details: a texture's name becomes its face.
  #richer(path, kind, value) {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'quiet small';
    button.textContent = '…';
    button.title = 'More settings';
    button.setAttribute('aria-label', 'More settings');
    button.addEventListener('click', () => {
      const made = this.#schema.sample({ type: 'object' }, (what) => this.#names(what));
      for (const key of kind.needed)
        made[key] = this.#schema.sample(kind.keys.get(key), (what) => this.#names(what), key);
      const first = kind.needed[0] ?? 'all';
      if (value !== undefined && kind.keys.has(first)) made[first] = value;
      this.#open.add(String(path));
      this.#set(path, made);
    });
    return button;
  }

  // ---- Parts that open

  #part(path, said, kind, value, { node, key, isNeeded }) {
    const name = keyed(path) ? key : titleOf(said, key);
    if (value === undefined) {
      const button = document.createElement('button');
      button.type = 'button';
      button.className = 'quiet add-part';
      button.textContent = `+ ${name}`;
      explain(button, said);
      button.dataset.path = String(path);
      button.addEventListener('click', () => {
        this.#open.add(String(path));
        this.#set(
          path,
          this.#schema.sample(node, (what) => this.#names(what), key),
        );
      });
      return button;
    }
    const part = document.createElement('details');
    const summary = document.createElement('summary');
    explain(summary, said);
    summary.dataset.path = String(path);
    const title = document.createElement('span');
    title.textContent = name;
    const glance = document.createElement('span');
    glance.className = 'soft';
    glance.textContent = glanceAt(value);
    summary.append(title, glance);
    part.append(summary);
    part.open = this.#open.has(String(path));
    const body = document.createElement('div');
    body.className = 'inside';
    const fill = () => {
      body.replaceChildren(
        ...(keyed(path) ? [this.#renamer(path)] : []),
        ...(kind === undefined ? [] : this.#membersOf(path, value)),
      );
      if (!isNeeded) body.append(this.#remover(path, name));
    };
    part.append(body);
    if (part.open) fill();
    part.addEventListener('toggle', () => {
      if (part.open && body.childElementCount === 0) fill();
      this.#open[part.open ? 'add' : 'delete'](String(path));
    });
    return part;
  }

  #renamer(path) {
    const line = document.createElement('p');
    line.className = 'field';
    const label = document.createElement('label');
    label.textContent = 'Name';
    const input = this.#nameInput(path);
    input.id = `form-${(ids += 1)}`;
    label.htmlFor = input.id;
    line.append(label, input);
    return line;
  }

  // For another name; what refers to it goes along.
  #nameInput(path) {
    const input = document.createElement('input');
    input.value = path.at(-1);
    input.title = 'The name. All that refers to it gets the new one, too.';
    input.setAttribute('aria-label', `${path.at(-1)}: name`);
    input.className = 'name';
    input.spellcheck = false;
    input.dataset.path = `${path} rename`;
    input.addEventListener('change', () => {
      const name = input.value.trim();
      this.#open.add(String([...path.slice(0, -1), name]));
      const isWhole = String(path) === String(this.#path);
      const change = renameChange(this.#editor.scene, path, name);
      if (isWhole && change.words === undefined) this.#path = [path[0], name];
      this.#do('Rename', change, `rename ${path}`);
    });
    return input;
  }

  #remover(path, name) {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'quiet remove-part';
    button.textContent = `Remove ${name}`;
    button.dataset.path = `${path} remove`;
    button.addEventListener('click', () => this.#set(path, undefined));
    return button;
  }

  #adder(path, index, item) {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'quiet add-part';
    button.textContent = '+ Another';
    button.dataset.path = `${path} another`;
    button.addEventListener('click', () => {
      this.#open.add(String([...path, index]));
      this.#set(
        [...path, index],
        this.#schema.sample(item, (what) => this.#names(what)),
      );
    });
    return button;
  }

  // A field for the name of a new entry.
  #namer(path, node) {
    const line = document.createElement('p');
    line.className = 'field';
    const input = document.createElement('input');
    input.placeholder = 'new name';
    input.setAttribute('aria-label', 'New name');
    input.dataset.path = `${path} name`;
    input.addEventListener('change', () => {
      const name = input.value.trim();
      if (name === '' || valueAt(this.#editor.scene.value, [...path, name]) !== undefined) return;
      this.#open.add(String([...path, name]));
      this.#set(
        [...path, name],
        this.#schema.sample(node, (what) => this.#names(what), name),
      );
    });
    const label = document.createElement('label');
    label.textContent = '+ Another';
    line.append(label, input);
    return line;
  }
}

const titleOf = ({ title }, key) => (/^\d+$/.test(key) ? `${title} ${key}`.trim() : title || key);

// Said below the form for a line that is pointed at or focused.
function explain(line, { about }) {
  if (about !== '') line.dataset.about = about;
}

// About as many as the text needs, and room for another one.
function rowsOf(text) {
  const lines = text.split('\n').map((line) => Math.ceil(line.length / kRow) || 1);
  return (text === '' ? 0 : 1) + lines.reduce((sum, count) => sum + count, 0);
}

const textOf = (value) => (Array.isArray(value) ? value.join(', ') : String(value));

function glanceAt(value) {
  const text = Array.isArray(value)
    ? String(value.length)
    : typeof value === 'object'
      ? String(value.name ?? value.sprite ?? value.kind ?? value.do ?? '')
      : String(value);
  return text.length > kSummary ? `${text.slice(0, kSummary)}…` : text;
}

// Lists of numbers or texts fit into one field.
function isPlainList(schema, { item }) {
  return schema.of(item).kinds.every(({ type }) => ['number', 'integer', 'text'].includes(type));
}

function readList(schema, { item }, text) {
  if (text.trim() === '') return [];
  const [{ type }] = schema.of(item).kinds;
  const parts = text.split(',').map((part) => part.trim());
  return type === 'text' ? parts : parts.map(Number);
}
