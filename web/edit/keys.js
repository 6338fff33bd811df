// The keys of the editor. Takes actions; knows no view and no document.
//
//     listenToKeys(actions, camera, tools, { isWalking() {}, isSteering() {} });
//     keyHelp(dialog, button, tools);

import { isTouch } from './fingers.js';

// By finger, and by mouse and keyboard: [what one does, its effect]
const kFingers = [
  [
    'Build',
    [
      ['Tap', 'use the tool'],
      ['Drag', 'a row of blocks, from corner to corner, or a thing to its place'],
      ['Remove', 'above the picture: taps and drags take away; once more to put again'],
      ['Undo, Redo', 'in the bar at the top'],
      ['Done', 'ends a way'],
      ['Select', 'copy, move, turn, fill or delete a part of the world'],
    ],
  ],
  [
    'Look',
    [
      ['Two fingers', 'turn the view; apart or together, fly ahead or back'],
      ['Two fingers', 'in the plan and the side view: move and zoom'],
      ['▲, ▼', 'in the plan another level, in the side view another section'],
      ['Walk', 'the left thumb walks, the right one looks around'],
    ],
  ],
];

const kGroups = [
  [
    'Build',
    [
      ['Click', 'use the tool'],
      ['Right click, Delete', 'remove'],
      ['Middle click, Alt and click', 'choose the block that is pointed at'],
      ['Alt, dragged', 'raise and lower a thing'],
      [
        'Insert, Enter',
        'use the tool at the pointer, or ahead; twice for what has two corners; Enter ends a way',
      ],
      ['O', 'turn through what the tool makes'],
      ['1 to 9', 'choose a block; , and . the one before and after'],
      ['Escape', 'leave a stroke as if it had not begun'],
      ['Ctrl Z, Ctrl Y', 'undo, redo'],
      ['Ctrl S', 'save'],
      ['Ctrl D', 'duplicate the thing that was chosen last'],
    ],
  ],
  [
    'Select (M) and paste',
    [
      ['Ctrl A', 'select all of the map; Escape selects none'],
      ['Ctrl C, Ctrl X, Ctrl V', 'copy, cut, paste where you point, also in another tab'],
      ['Delete', 'remove what is selected'],
      ['N', 'fill it with the chosen block'],
      ['Arrows', 'move it by a tile; Shift and up or down, by a level'],
      ['U, I', 'turn clockwise, mirror; with Shift the other way'],
      ['Page up, Page down', 'while dragging: more levels, as the wheel does'],
      ['Shift K', 'save it as a stamp'],
    ],
  ],
  [
    'Move',
    [
      ['W A S D, arrows', 'fly'],
      ['Space or E, C or Q', 'rise, sink'],
      ['Shift', 'faster'],
      ['Right button, dragged', 'look around'],
      ['Wheel', 'ahead and back'],
      ['Tab', 'walk; Tab or Escape, back to editing; Shift and Tab goes to the buttons'],
    ],
  ],
  [
    'See',
    [
      ['G', 'picture or plan'],
      ['V', 'side view; again: from west to east, or from north to south'],
      ['J', 'text'],
      ['Arrows', 'in the plan: point to the next tile'],
      ['Page up, Page down', 'a level up, down; while a box is drawn, higher and lower'],
      ['Arrows, Shift and wheel', 'the next section, in the side view'],
      ['+, -, 0', 'plan and side view larger, smaller, as a whole'],
    ],
  ],
];

export function listenToKeys(actions, camera, tools, { isWalking, isSteering }) {
  addEventListener(
    'keydown',
    (event) => {
      if (document.querySelector('dialog[open]') !== null) return;
      if (isSaveKey(event)) {
        event.preventDefault();
        event.stopPropagation();
        if (!event.repeat) actions.save();
        return;
      }
      if (event.code === 'Tab' && isWalkKey(event)) {
        event.preventDefault();
        event.stopPropagation();
        actions.walk();
        return;
      }
      if (isWalking()) {
        if (isSteering()) leaveByEscape(event);
        return;
      }
      if (!isFree(event.target) && !isUndoOfText(event)) return;
      if (take(event)) event.preventDefault();
    },
    true,
  );
  // While nobody steers, the list of keys over the picture comes first.
  addEventListener('keydown', (event) => isWalking() && leaveByEscape(event));
  addEventListener('keyup', ({ code, shiftKey }) => {
    camera.release(code);
    camera.isFast = shiftKey;
  });
  addEventListener('blur', () => camera.stop());

  function leaveByEscape(event) {
    if (event.code !== 'Escape' || event.defaultPrevented) return;
    event.preventDefault();
    event.stopPropagation();
    actions.walk();
  }

  function take(event) {
    const { code, key, ctrlKey, metaKey, altKey, shiftKey } = event;
    if (altKey) return false;
    if (ctrlKey || metaKey) {
      if (code === 'KeyZ') (shiftKey ? actions.redo : actions.undo)();
      else if (code === 'KeyY') actions.redo();
      else if (code === 'KeyD' && !shiftKey) actions.duplicate();
      else return actions.selectionKey(event);
      return true;
    }
    camera.isFast = shiftKey;
    if (actions.selectionKey(event) || actions.ofView(event)) return true;
    if (/^[1-9]$/.test(key)) actions.digit(Number(key));
    else if (code === 'Delete' || code === 'Backspace') actions.remove();
    else if (code === 'Enter') {
      if (actions.finish()) return true;
      if (event.target.closest?.('button, a, select') !== null) return false;
      actions.use();
    } else if (code === 'Insert') actions.use();
    else if (code === 'Escape') actions.cancel();
    else if (code === 'PageUp') actions.level(1);
    else if (code === 'PageDown') actions.level(-1);
    else if (key === ',') actions.next(-1);
    else if (key === '.') actions.next(1);
    else if (code === 'KeyG') actions.nextView();
    else if (code === 'KeyV') actions.sideView();
    else if (code === 'KeyJ') actions.view('text');
    else if (code === 'KeyO') actions.way();
    else {
      const tool = tools.find((one) => `Key${one.key}` === code);
      if (tool !== undefined) actions.tool(tool.name);
      else if (code === 'Space' && event.target.closest?.('button, a, select') !== null)
        return false;
      else return camera.press(code);
    }
    return true;
  }
}

// Elsewhere Tab goes from button to button, as does Shift and Tab everywhere.
function isWalkKey({ target, ctrlKey, altKey, shiftKey }) {
  return !ctrlKey && !altKey && !shiftKey && target.matches('body, #picture, .flat');
}

function isSaveKey({ code, ctrlKey, metaKey, altKey, shiftKey }) {
  return code === 'KeyS' && (ctrlKey || metaKey) && !altKey && !shiftKey;
}

// The text has no history of its own.
function isUndoOfText({ target, code, ctrlKey, metaKey }) {
  const isUndo = (ctrlKey || metaKey) && (code === 'KeyZ' || code === 'KeyY');
  return isUndo && target.closest?.('.cm-editor') !== null;
}

// Where one types, keys are letters.
function isFree(target) {
  return target.closest?.('input, select, textarea, .cm-editor') === null;
}

export function keyHelp(dialog, button, tools) {
  const part = (name) => dialog.querySelector(`[data-keys=${name}]`);
  const byKey = tools.map(({ key, label, about }) => [key, `${label}. ${about}`]);
  part('fingers').append(
    ...kFingers.flatMap(group),
    ...group(['Tools', tools.map(({ label, touch, about }) => [label, touch ?? about])]),
  );
  part('tables').append(...[...kGroups, ['Tools', byKey]].flatMap(group));
  button.addEventListener('click', () => {
    part('keyboard').open = !isTouch();
    dialog.showModal();
  });
}

function group([title, rows]) {
  const heading = document.createElement('h3');
  heading.textContent = title;
  const list = document.createElement('div');
  list.className = 'keys';
  for (const [keys, does] of rows) {
    const key = document.createElement('span');
    key.append(...keys.split(/(, )/).map((part) => (part === ', ' ? part : keyOf(part))));
    const what = document.createElement('span');
    what.textContent = does;
    list.append(key, what);
  }
  return [heading, list];
}

function keyOf(text) {
  const key = document.createElement('kbd');
  key.textContent = text;
  return key;
}
