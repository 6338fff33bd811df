// Something that keeps a scene from being shown, and the sheet that says so.
//
//     throw new Trouble('The scene could not be loaded', 'scenes/castle.json: the server answers 404');
//     sheet.show(trouble, {again, scenes, back});

const kActions = ['again', 'scenes', 'back'];

// `faults` are the engine's: {file, pointer, line, column, row, character, found, expected}. The
// code is one of element/faults.js.
export class Trouble extends Error {
  constructor(title, text, faults = [], code = faults.length > 0 ? 'scene' : 'engine') {
    super(text);
    this.title = title;
    this.faults = faults;
    this.code = code;
  }
}

// Whether the engine itself has failed and cannot go on. Where there is no WebAssembly there is no
// such error either.
export function isEngineFailure(error) {
  return typeof WebAssembly === 'object' && error instanceof WebAssembly.RuntimeError;
}

// Anything that was thrown, as a Trouble.
export function asTrouble(error) {
  if (error instanceof Trouble) return error;
  console.error(error);
  if (isEngineFailure(error))
    return new Trouble(
      'The engine has stopped',
      `It cannot go on: ${error.message}. Load the page again.`,
    );
  return new Trouble(
    'Something went wrong',
    error instanceof Error ? error.message : String(error),
  );
}

export class TroubleSheet {
  constructor(root) {
    this.root = root;
    this.find = (name) => root.querySelector(`#trouble-${name}`);
    this.actions = {};
    for (const name of kActions)
      this.find(name).addEventListener('click', () => this.actions[name]());
  }

  // `actions` are functions, or null where there is no way: {again, scenes, back}.
  show(trouble, actions) {
    this.actions = actions;
    this.find('title').textContent = trouble.title;
    this.find('text').textContent = trouble.message;
    this.find('faults').hidden = trouble.faults.length === 0;
    this.root.classList.toggle('has-faults', trouble.faults.length > 0);
    this.root.querySelector('tbody').replaceChildren(...trouble.faults.map(faultRow));
    for (const name of kActions) this.find(name).hidden = actions[name] === null;
    this.find('actions').hidden = false;
    this.root.hidden = false;
  }

  hide() {
    this.root.hidden = true;
  }
}

// "castle.json:12:5", as editors and terminals write a place.
export function placeOf(fault) {
  return fault.line > 0 ? `${fault.file}:${fault.line}:${fault.column}` : fault.file;
}

// The same place as the scene itself would name it: a JSON pointer, and within a grid of characters
// the tile.
function insideOf({ pointer, row, character }) {
  const tile = [row >= 0 ? `row ${row}` : '', character >= 0 ? `character ${character}` : '']
    .filter((part) => part !== '')
    .join(', ');
  return tile === '' ? pointer : `${pointer}, ${tile}`;
}

function faultRow(fault) {
  const row = document.createElement('tr');
  const place = document.createElement('th');
  place.scope = 'row';
  place.textContent = placeOf(fault);
  const inside = insideOf(fault);
  if (inside !== '') {
    const where = document.createElement('span');
    where.className = 'inside';
    where.textContent = inside;
    place.append(where);
  }
  const found = document.createElement('td');
  found.className = 'found';
  found.dataset.label = 'Found';
  found.textContent = fault.found;
  const expected = document.createElement('td');
  expected.dataset.label = 'Expected';
  expected.textContent = fault.expected;
  row.append(place, found, expected);
  return row;
}
