// What is chosen, and what the pointer does with it: the chosen tool acts on the document.
// Takes targets from the views; gives changes to the history, and lines to show. Knows no view.
//
//     const editor = new Editor(scene, history);
//     editor.choose({ tool: place });  editor.choose({ sign: '#' });
//     editor.point(target);                       // the pointer is there; null: nowhere
//     editor.press(target, { removes: false });   // a stroke begins, goes on by point()
//     editor.release();
//     editor.listen((what) => ...);               // 'choice', 'marks'
//
// A target is {map, mapName, cell, before, face, point, thing}, where each may be null but the
// first two: the cell that is pointed at; the free cell before its face, where a block would be
// placed; its face; the point in units; the path of an object, a lamp or the start. Cells are
// {level, x, y}.

import { kindsOf } from './kinds.js';
import { kBrass, linesOf } from './mark-lines.js';
import { outlineOf } from './selection.js';
import { valueAt } from './things.js';

let strokes = 0;

export class Editor {
  #listeners = [];
  #target = null;
  #stroke = null; // {key, targets, removes, height}

  // What is chosen
  map = 0;
  level = 0; // of the plan
  tool;
  sign = '';
  texture = null; // to paint with
  thing = null; // to put: 'start', 'lamp', or {name, height} of a sprite
  edited = null; // the path of the thing that was last touched
  isWhole = false; // Shift is held
  selection = null; // {map, cells}: what is selected, see selection.js
  adds = false; // to what is selected, also without Shift
  brush = null; // {part, turn, name}: what is pasted, see parts.js
  world = ''; // under which name the world is kept
  #ways = new Map(); // of the tools: name -> way
  #remembered = new Map(); // length of the history -> selection

  constructor(scene, history, tool) {
    this.scene = scene;
    this.history = history;
    this.tool = tool;
    scene.listen(() => this.#check());
    this.#check();
  }

  listen(listener) {
    this.#listeners.push(listener);
  }

  choose(choice) {
    Object.assign(this, choice);
    this.#check();
    this.#tell('choice');
    this.#tell('marks');
  }

  // How the tool works, of those that it has.
  get way() {
    return this.#ways.get(this.tool.name) ?? this.tool.ways?.[0];
  }

  set way(way) {
    this.#ways.set(this.tool.name, way);
  }

  get stroke() {
    return this.#stroke;
  }

  get target() {
    return this.#target;
  }

  get mapName() {
    return this.scene.value.maps[this.map].name;
  }

  // The lines to show over the picture.
  get marks() {
    if (this.#stroke !== null && this.tool.show !== undefined)
      return this.tool.show(this.#stroke, this.#context);
    const lines = this.#target === null ? [] : this.tool.point(this.#target, this.#context);
    return [...this.#selected, ...lines];
  }

  // The cells that the tool would change, or has selected, where a view shows them as a set.
  get touched() {
    if (this.#stroke !== null) return this.tool.cells?.(this.#stroke, this.#context) ?? null;
    if (this.#target === null) return null;
    return this.tool.ghost?.(this.#target, this.#context) ?? null;
  }

  // The outline of those cells.
  get touchedEdges() {
    const at = this.#stroke ?? this.#target;
    if (at === null) return [];
    return this.tool.edges?.(at, this.#context) ?? outlineOf(this.touched ?? new Set());
  }

  get #selected() {
    if (!this.tool.hasSelection || this.selection === null) return [];
    return linesOf(this.mapName, this.selectedOutline, kBrass);
  }

  // Its edges, found once.
  get selectedOutline() {
    if (this.selection === null) return [];
    this.selection.outline ??= outlineOf(this.selection.cells);
    return this.selection.outline;
  }

  // What was selected before and after the last change, so that undo brings it back.
  remember(before, after) {
    const { length } = this.history;
    this.#remembered.set(length - 1, before);
    this.#remembered.set(length, after);
  }

  // After undo and redo. What was selected meanwhile stays.
  recall() {
    const known = [...this.#remembered.values()];
    const next = this.#remembered.get(this.history.length);
    if (next !== undefined && known.includes(this.selection)) this.choose({ selection: next });
  }

  point(target) {
    this.#target = target;
    if (this.#stroke !== null && target !== null && target.map === this.#stroke.targets[0].map) {
      const last = this.#stroke.targets.at(-1);
      if (!isSamePlace(target, last, this.tool.hasThings === true)) {
        this.#stroke.targets.push(target);
        this.#drag();
      }
    }
    this.#tell('marks');
  }

  press(target, { removes = false } = {}) {
    strokes += 1;
    const adds = this.isWhole || this.adds;
    this.#stroke = { key: `stroke ${strokes}`, targets: [target], removes, adds, height: 0 };
    this.#target = target;
    if (this.tool.hasThings && !removes && target.thing !== null)
      this.choose({ edited: target.thing });
    this.#drag();
    this.#tell('marks');
  }

  release() {
    const stroke = this.#stroke;
    this.#stroke = null;
    if (stroke === null) return;
    const context = { ...this.#context, removes: stroke.removes };
    const selection = this.tool.select?.(stroke, context);
    if (this.tool.end !== undefined) this.#do(this.tool.end(stroke, context), stroke);
    this.history.close();
    if (stroke.isDone && selection !== undefined) this.remember(this.selection, selection);
    if (selection !== undefined) this.choose({ selection });
    this.#tell('marks');
  }

  // Leaves what the stroke has done so far, as if it had not begun.
  cancel() {
    const stroke = this.#stroke;
    this.#stroke = null;
    if (stroke?.isDone) this.history.undo();
    this.#tell('marks');
  }

  // Notches of the wheel, up positive. False if the tool has no use for them.
  turn(notches) {
    if (this.#stroke !== null && this.tool.show !== undefined) {
      this.#stroke.height += Math.sign(notches);
      this.#tell('marks');
      return true;
    }
    if (this.tool.turn === undefined || this.#target === null) return false;
    const changes = this.tool.turn(this.#target, notches, this.#context);
    const { cell } = this.#target;
    this.history.do(this.tool.label, changes, `turn ${JSON.stringify(cell)}`);
    this.#tell('marks');
    return true;
  }

  // Chooses the block that is pointed at.
  pick(target) {
    const { map, cell } = target;
    if (cell === null) return;
    const sign = this.scene.sign(map, cell.level, cell.x, cell.y);
    if (sign !== '.') this.choose({ sign });
  }

  get #context() {
    const { scene, sign, texture, thing, way, isWhole, selection, brush, world } = this;
    const removes = this.#stroke?.removes ?? false;
    return { scene, sign, texture, thing, way, isWhole, selection, brush, world, removes };
  }

  #drag() {
    if (this.tool.drag !== undefined)
      this.#do(this.tool.drag(this.#stroke, this.#context), this.#stroke);
  }

  #do(changes, stroke) {
    if (changes.length === 0) return;
    stroke.isDone = true;
    this.history.do(stroke.removes ? 'Remove' : this.tool.label, changes, stroke.key);
  }

  // What was chosen may be gone.
  #check() {
    const { maps } = this.scene.value;
    if (this.map >= maps.length) this.map = maps.length - 1;
    if (this.selection !== null && this.selection.map !== this.map) this.selection = null;
    const kinds = kindsOf(this.scene, this.map);
    if (!kinds.some(({ sign }) => sign === this.sign)) this.sign = kinds[0]?.sign ?? '';
    const { textures = {}, sprites = {} } = this.scene.value;
    if (this.thing?.name !== undefined && !Object.hasOwn(sprites, this.thing.name))
      this.thing = null;
    this.thing ??= 'start';
    if (this.edited !== null && valueAt(this.scene.value, this.edited) === undefined)
      this.edited = null;
    if (!Object.hasOwn(textures, this.texture ?? ''))
      this.texture = Object.keys(textures)[0] ?? null;
  }

  #tell(what) {
    for (const listener of this.#listeners) listener(what);
  }
}

// With `isFine`, also within a cell.
function isSamePlace(one, other, isFine) {
  const placeOf = ({ cell, before, face, thing, point }) =>
    JSON.stringify([cell, before, face, thing, isFine ? point : null]);
  return placeOf(one) === placeOf(other);
}
