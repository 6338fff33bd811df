// What one does with the selection and with a pasted part: actions, their keys, and the bar that
// shows them. Takes an editor and stamps; gives changes to the history.
//
//     const selecting = new Selecting(bar, editor, { stamps, own, colourOf, tell, askName, plan });
//     selecting.key(event)        // true if it was one of its keys
//     selecting.escape()          // true if something was given up
//     selecting.remove()          // true if there is a selection, which is removed
//     selecting.useStamp(stamp)   // {name, part}: a choice of the editor

import { carryChanges, clearChanges, fillChanges } from './carrying.js';
import { kMostLevels } from './cells.js';
import { takePictures, withPictures } from './own-pictures.js';
import { isEmptyPart, partOf } from './parts.js';
import { boxAround, transformed, transformOf } from './selection.js';
import { allOf, columnsOf, select } from './tools/select.js';
import { stamp } from './tools/stamp.js';
import { composed, kStill, kTurns } from './turning.js';

const kWayLabels = { box: 'Box', 'same kind': 'Kind', joined: 'Joined' };
const kArrows = { ArrowUp: [0, -1], ArrowRight: [1, 0], ArrowDown: [0, 1], ArrowLeft: [-1, 0] };

export class Selecting {
  #bar;
  #editor;
  #page;
  #buttons = [];
  #before = null; // the tool before the stamp

  constructor(bar, editor, page) {
    this.#bar = bar;
    this.#editor = editor;
    this.#page = page;
    const hasSelection = () => editor.tool === select && editor.selection !== null;
    const isSelect = () => editor.tool === select;
    const hasBrush = () => editor.tool === stamp && editor.brush !== null;
    const canTurn = () => hasSelection() || hasBrush();
    const groups = [
      select.ways.map((way) => ({
        label: kWayLabels[way],
        about: {
          box: 'Select a box of cells (O: the next way)',
          'same kind': 'Select all blocks of the pointed kind in this map (O: the next way)',
          joined: 'Select the blocks of a kind that touch (O: the next way)',
        }[way],
        isShown: isSelect,
        isOn: () => editor.way === way,
        act: () => editor.choose({ way }),
      })),
      [
        {
          label: 'Add',
          about: 'Add to what is selected (Shift)',
          isShown: isSelect,
          isOn: () => editor.adds,
          act: () => editor.choose({ adds: !editor.adds }),
        },
        {
          label: 'Columns',
          about: 'Select all levels of the selected tiles',
          isShown: hasSelection,
          act: () => editor.choose({ selection: columnsOf(editor.scene, editor.selection) }),
        },
      ],
      [
        ['Copy', 'Copy the selection (Ctrl+C)', () => this.#copy()],
        ['Cut', 'Copy and remove the selection (Ctrl+X)', () => this.#cut()],
        ['Fill', 'Fill the selected cells with the chosen block (N)', () => this.#fill()],
        ['Delete', 'Remove what is selected (Delete)', () => this.remove()],
      ].map(([label, about, act]) => ({ label, about, act, isShown: hasSelection })),
      [
        ['Turn', 'Turn clockwise by 90 degrees (U; Shift+U the other way)', kTurns.right],
        ['↔', 'Mirror: west and east change places (I)', kTurns['west-east']],
        ['↕', 'Mirror: north and south change places (Shift+I)', kTurns['north-south']],
      ].map(([label, about, turn]) => ({
        label,
        about,
        act: () => this.#turn(turn),
        isShown: canTurn,
      })),
      [
        {
          label: 'Up',
          about: 'Move a level up (Shift+arrow up); arrows move by a tile',
          act: () => this.#move({ level: 1, x: 0, y: 0 }),
          isShown: hasSelection,
        },
        {
          label: 'Down',
          about: 'Move a level down (Shift+arrow down); arrows move by a tile',
          act: () => this.#move({ level: -1, x: 0, y: 0 }),
          isShown: hasSelection,
        },
      ],
      [
        {
          label: 'Save',
          about: 'Save as a stamp: kept under a name, for all worlds (Shift+K)',
          isShown: hasSelection,
          act: () => this.save(),
        },
        {
          label: 'Forget',
          about: 'Remove the stamp from this browser',
          isShown: () => hasBrush() && editor.brush.name !== null,
          act: () => this.#forget(),
        },
        {
          label: 'Paste',
          about: 'Put what was copied where you point (Ctrl+V)',
          isShown: () => isSelect() || editor.tool === stamp,
          act: () => this.#paste(),
        },
        {
          label: 'Done',
          about: 'Stop pasting (Escape)',
          isShown: hasBrush,
          act: () => this.escape(),
        },
      ],
    ];
    for (const group of groups) this.#group(group);
    editor.listen((what) => what === 'choice' && this.#show());
    this.#show();
  }

  #group(actions) {
    const place = document.createElement('span');
    place.className = 'group';
    for (const action of actions) {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = action.label;
      button.title = action.about;
      if (action.label.length < 2)
        button.setAttribute('aria-label', action.about.replace(/ \(.*/, ''));
      button.addEventListener('click', () => action.act());
      place.append(button);
      this.#buttons.push({ ...action, button });
    }
    this.#bar.append(place);
  }

  #show() {
    const { tool, selection } = this.#editor;
    this.#bar.hidden = tool !== select && tool !== stamp;
    for (const { button, isShown, isOn } of this.#buttons) {
      button.hidden = !isShown();
      if (isOn !== undefined) button.setAttribute('aria-pressed', String(isOn()));
    }
    for (const group of this.#bar.children)
      group.hidden = [...group.children].every((button) => button.hidden);
    const count = selection?.cells.size ?? 0;
    this.#bar.setAttribute(
      'aria-label',
      count === 0 ? 'Selection' : `Selection: ${count} ${count === 1 ? 'cell' : 'cells'}`,
    );
  }

  // ---- Keys

  key({ code, ctrlKey, metaKey, shiftKey, target }) {
    const editor = this.#editor;
    const hasSelection = editor.tool === select && editor.selection !== null;
    const hasBrush = editor.tool === stamp && editor.brush !== null;
    if (ctrlKey || metaKey) {
      if (code === 'KeyV') this.#paste();
      else if (code === 'KeyA') this.all();
      else if (code === 'KeyC' && hasSelection) this.#copy();
      else if (code === 'KeyX' && hasSelection) this.#cut();
      else return false;
      return true;
    }
    if (editor.stroke !== null) {
      const by = { PageUp: 1, PageDown: -1 }[code];
      return by !== undefined && editor.turn(by);
    }
    if (!hasSelection && !hasBrush) return false;
    if (code === 'KeyU') this.#turn(shiftKey ? kTurns.left : kTurns.right);
    else if (code === 'KeyI') this.#turn(kTurns[shiftKey ? 'north-south' : 'west-east']);
    else if (!hasSelection) return false;
    else if (code === 'KeyN') this.#fill();
    else if (code === 'KeyK' && shiftKey) this.save();
    else if (kArrows[code] !== undefined && target.closest?.('[role=tablist]') == null)
      this.#move(this.#stepOf(code, shiftKey));
    else return false;
    return true;
  }

  // In the picture, the arrow up leads away from the eye.
  #stepOf(code, isUpright) {
    const [right, down] = kArrows[code];
    if (isUpright) return { level: -down, x: 0, y: 0 };
    const quarters = this.#page.quarters();
    let [x, y] = [right, down];
    for (let count = 0; count < quarters; ++count) [x, y] = [-y, x];
    return { level: 0, x, y };
  }

  escape() {
    const editor = this.#editor;
    if (editor.stroke !== null) return false;
    if (editor.tool === stamp && editor.brush !== null) {
      editor.choose({ brush: null, tool: this.#before ?? select });
      return true;
    }
    if (editor.tool !== select || editor.selection === null) return false;
    editor.choose({ selection: null });
    return true;
  }

  // ---- Actions

  #do(label, changes) {
    this.#editor.history.do(label, changes);
  }

  all() {
    const { scene, map } = this.#editor;
    const cells = allOf(scene, map);
    this.#editor.choose({ tool: select, selection: cells.size === 0 ? null : { map, cells } });
  }

  remove() {
    const { scene, selection, tool } = this.#editor;
    if (tool !== select || selection === null) return false;
    this.#do('Remove the selection', clearChanges(scene, selection.map, selection.cells));
    return true;
  }

  #fill() {
    const { scene, selection, sign } = this.#editor;
    this.#do('Fill the selection', fillChanges(scene, selection.map, selection.cells, sign));
  }

  #carry(label, turn, by) {
    const { scene, selection } = this.#editor;
    const { map, cells } = selection;
    const box = boxAround(cells);
    if (box.from.level + by.level < 0 || box.to.level + by.level >= kMostLevels) return;
    const transform = transformOf(box, turn, by);
    this.#do(label, carryChanges(scene, map, cells, transform));
    const next = { map, cells: transformed(cells, transform) };
    this.#editor.remember(selection, next);
    this.#editor.choose({ selection: next });
  }

  #move(by) {
    this.#carry('Move', kStill, by);
  }

  #turn(turn) {
    const { brush, tool } = this.#editor;
    if (tool === stamp)
      this.#editor.choose({ brush: { ...brush, turn: composed(brush.turn, turn) } });
    else this.#carry('Turn', turn, { level: 0, x: 0, y: 0 });
  }

  #part() {
    const { scene, selection, world } = this.#editor;
    const part = partOf(scene, selection.map, selection.cells, world);
    if (isEmptyPart(part)) {
      this.#page.tell('There is nothing in the selected cells.');
      return null;
    }
    part.colours = Object.fromEntries(
      Object.entries(part.legend).map(([sign, name]) => [
        sign,
        this.#page.colourOf(part.blueprints[name]),
      ]),
    );
    return withPictures(part, this.#page.own);
  }

  async #copy() {
    const part = this.#part();
    if (part === null) return false;
    await this.#page.stamps.copy(part);
    this.#page.tell('Copied. Paste puts it where you point, also in another tab.');
    return true;
  }

  #cut() {
    const part = this.#part();
    if (part === null) return;
    this.#page.stamps.copy(part);
    this.remove();
  }

  async #paste() {
    const part = await this.#page.stamps.copied();
    if (part === null) this.#page.tell('Nothing was copied yet. Select something and copy it.');
    else this.#editor.choose(this.useStamp({ name: null, part }));
  }

  // A choice of the editor: the part follows the pointer.
  useStamp({ name, part }) {
    const { tool } = this.#editor;
    if (tool !== stamp) this.#before = tool;
    return { tool: stamp, brush: { name, part: takePictures(part, this.#page.own), turn: kStill } };
  }

  async save() {
    const { selection } = this.#editor;
    if (selection === null) {
      this.#page.tell('Select something first, then save it as a stamp.');
      return;
    }
    const part = this.#part();
    if (part === null) return;
    const { stamps } = this.#page;
    const count = stamps.all.length + 1;
    const name = await this.#page.askName('Save as a stamp', `stamp ${count}`);
    if (name === null) return;
    const isKept = await stamps.save(name, part);
    this.#page.tell(
      isKept
        ? `Saved as “${name}”. The tool Stamp shows it.`
        : 'This browser keeps nothing: the stamp is there until you close the page.',
    );
  }

  async #forget() {
    const { name } = this.#editor.brush;
    this.escape();
    await this.#page.stamps.remove(name);
    this.#page.tell(`The stamp “${name}” is gone.`);
  }
}
