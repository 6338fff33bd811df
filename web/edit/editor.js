// What is chosen, and what the pointer does with it: the chosen tool acts on the document.
// Takes targets from the views; gives changes to the history, and lines to show. Knows no view.
//
//     const editor = new Editor(scene, history);
//     editor.choose({ tool: place });  editor.choose({ sign: '#' });
//     editor.point(target);                       // the pointer is there; null: nowhere
//     editor.press(target, { removes: false });   // a stroke begins, goes on by point()
//     editor.release();
//     editor.listen((what, more) => ...);         // 'choice' and which, 'marks', 'words' to show
//
// A target is {map, mapName, cell, before, face, point, thing}, where each may be null but the
// first two: the cell that is pointed at; the free cell before its face, where a block would be
// placed; its face; the point in units; the path of a handle (handles.js). Cells are
// {level, x, y}. Besides, `view` is 'plan' for one seen from above, and `lift` a height to which a
// thing is dragged.

import { plainKind } from './gates.js';
import { copyOf, formPathOf, lastPointOf, removeChanges } from './handles.js';
import { kindsOf } from './kinds.js';
import { isOfThing, linkLines, shownLinks } from './link-marks.js';
import { Links } from './links.js';
import { kBrass, linesOf } from './mark-lines.js';
import { outlineOf } from './selection.js';
import { pictureOf } from './files/shipped.js';
import { tableOf } from './names.js';
import { valueAt } from './things.js';

const kMaterials = ['sign', 'texture', 'thing']; // who chooses one wants to put it
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
  thing = null; // to put: 'start', 'lamp', 'message', 'goal', {find}, or a sprite's {name, height}
  pending = null; // {kind, ...}: what the tool has begun, and goes on with the next click
  edited = null; // the path of the thing that was last touched
  section = null; // {axis, at} of the side view, while it is in use; see section.js
  isWhole = false; // Shift is held
  selection = null; // {map, cells}: what is selected, see selection.js
  removes = false; // what is pressed, also with the left button or a finger
  isTouch = false; // somebody works by finger
  adds = false; // to what is selected, also without Shift
  brush = null; // {part, turn, name}: what is pasted, see parts.js
  world = ''; // under which name the world is kept
  #ways = new Map(); // of the tools: name -> way
  #remembered = new Map(); // length of the history -> selection

  constructor(scene, history, tool) {
    this.scene = scene;
    this.history = history;
    this.tool = tool;
    this.links = new Links(scene);
    scene.listen(() => this.#check());
    this.#check();
  }

  listen(listener) {
    this.#listeners.push(listener);
  }

  choose(choice) {
    const { tool, way } = this;
    Object.assign(this, choice);
    if (this.tool !== tool || kMaterials.some((name) => choice[name] !== undefined))
      this.removes = false;
    if ((this.tool !== tool || this.way !== way) && choice.pending === undefined)
      this.pending = null;
    this.#check();
    this.#tell('choice', choice);
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
    const { edited } = this;
    const links = linkLines(this.mapName, shownLinks(this), (link) => isOfThing(link, edited));
    return [...links, ...this.toolMarks];
  }

  get toolMarks() {
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

  press(target, { removes = this.removes } = {}) {
    strokes += 1;
    const adds = this.isWhole || this.adds;
    this.#stroke = { key: `stroke ${strokes}`, targets: [target], removes, adds, height: 0 };
    this.#target = target;
    if (this.tool.hasThings && !removes && target.thing !== null)
      this.choose({ edited: formPathOf(target.thing) });
    this.#drag();
    this.#tell('marks');
  }

  release() {
    const stroke = this.#stroke;
    this.#stroke = null;
    if (stroke === null) return;
    const context = { ...this.#context, removes: stroke.removes };
    const selection = this.tool.select?.(stroke, context);
    if (this.tool.end !== undefined) this.#take(this.tool.end(stroke, context), stroke);
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
    if (stroke === null && this.pending !== null) this.choose({ pending: null });
    this.#tell('marks');
  }

  // Ends a way, whatever number of points it has. False if there is none.
  finish() {
    if (this.pending?.kind !== 'way') return false;
    this.choose({ pending: null });
    return true;
  }

  // What was last touched, or the last point of a way that is being drawn: false if nothing was.
  removeEdited() {
    const { edited, scene, pending } = this;
    if (pending?.kind === 'way') {
      const point = lastPointOf(scene, pending.path);
      if (point !== null) this.history.do('Remove', removeChanges(scene, point));
      return true;
    }
    if (edited === null) return false;
    this.history.do('Remove', changesToRemove(scene, edited));
    this.choose({ edited: null });
    return true;
  }

  duplicate() {
    const copy = this.edited === null ? null : copyOf(this.scene, this.edited);
    if (copy === null) {
      this.#tell('words', 'Choose an object, a lamp or a message first: these can be copied.');
      return;
    }
    this.history.do('Duplicate', copy.changes);
    this.choose({ edited: copy.path });
  }

  say(words) {
    this.#tell('words', words);
  }

  // What the tool does, in words.
  get about() {
    const { tool, isTouch } = this;
    const usual = (isTouch && tool.touch) || tool.about;
    return this.hint ?? tool.help?.(this.#context) ?? usual;
  }

  // Words for what is pointed at; undefined if there are none.
  get hint() {
    const stroke = this.#stroke ?? { targets: [this.#target], removes: false, height: 0 };
    if (stroke.targets.at(-1) === null) return undefined;
    return this.tool.hint?.(stroke, this.#context);
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
    if (changes === null) return false;
    const { cell, thing } = this.#target;
    this.history.do(this.tool.label, changes, `turn ${JSON.stringify(thing ?? cell)}`);
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
    const { links, edited, pending } = this;
    const removes = this.#stroke?.removes ?? this.removes;
    return {
      ...{ scene, sign, texture, thing, way, isWhole, selection, brush, world },
      ...{ links, edited, pending, removes },
    };
  }

  #drag() {
    if (this.tool.drag !== undefined)
      this.#do(this.tool.drag(this.#stroke, this.#context), this.#stroke);
  }

  // A tool gives changes, or also what is chosen then: {changes, label, words, edited, pending}.
  #take(answer, stroke) {
    const {
      changes = [],
      label,
      words,
      ...choice
    } = Array.isArray(answer) ? { changes: answer } : answer;
    this.#do(changes, stroke, label);
    if (Object.keys(choice).length > 0) this.choose(choice);
    if (words !== undefined) this.#tell('words', words);
  }

  #do(changes, stroke, label = this.tool.label) {
    if (changes.length === 0) return;
    stroke.isDone = true;
    this.history.do(stroke.removes ? 'Remove' : label, changes, stroke.key);
  }

  // What was chosen may be gone.
  #check() {
    const { maps } = this.scene.value;
    if (this.map >= maps.length) this.map = maps.length - 1;
    if (this.selection !== null && this.selection.map !== this.map) this.selection = null;
    const kinds = kindsOf(this.scene, this.map);
    if (!kinds.some(({ sign }) => sign === this.sign)) this.sign = kinds[0]?.sign ?? '';
    const { value } = this.scene;
    if (
      this.thing?.name !== undefined &&
      pictureOf(value, 'sprites', this.thing.name) === undefined
    )
      this.thing = null;
    this.thing ??= 'start';
    if (this.edited !== null && valueAt(this.scene.value, this.edited) === undefined)
      this.edited = null;
    const { ways } = this.tool ?? {};
    if (ways !== undefined && !ways.includes(this.way)) this.way = ways[0];
    if (this.pending !== null && !isStillThere(this.scene.value, this.pending)) this.pending = null;
    if (pictureOf(value, 'textures', this.texture ?? '') === undefined)
      this.texture = Object.keys(tableOf(value, 'textures'))[0] ?? null;
  }

  #tell(what, more) {
    for (const listener of this.#listeners) listener(what, more);
  }
}

// After an undo, what was begun may be gone.
function isStillThere({ maps, blueprints }, { path, name, map, end }) {
  if (path !== undefined && valueAt({ maps, blueprints }, path) === undefined) return false;
  if (name !== undefined && blueprints?.[name]?.gate === undefined) return false;
  return (map ?? end?.map ?? 0) < maps.length;
}

// Blocks become plain; the kinds stay.
function changesToRemove(scene, path) {
  const { blueprints = {} } = scene.value;
  if (path[0] === 'blueprints') return plainKind(scene, path[1]);
  if (path[0] !== 'motions') return removeChanges(scene, path);
  const names = Object.keys(blueprints).filter((name) => blueprints[name].motion === path[1]);
  return names.flatMap((name) => plainKind(scene, name));
}

// With `isFine`, also within a cell.
function isSamePlace(one, other, isFine) {
  const placeOf = ({ cell, before, face, thing, point, lift }) =>
    JSON.stringify([cell, before, face, thing, isFine ? [point, lift] : null]);
  return placeOf(one) === placeOf(other);
}
