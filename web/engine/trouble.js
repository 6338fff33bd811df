// Something that keeps a scene from being shown.
//
//     throw new Trouble('The scene could not be loaded', 'scenes/castle.json: the server answers 404');

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

// The faults of a scene, as the engine or sceneOfRows lists them, as one error.
export function sceneFault(name, faults) {
  const count = faults.length === 1 ? 'One fault' : `${faults.length} faults`;
  return new Trouble(`${count} in ${name}`, 'It was read, but cannot be shown.', faults, 'scene');
}

// "castle.json:12:5", as editors and terminals write a place.
export function placeOf(fault) {
  return fault.line > 0 ? `${fault.file}:${fault.line}:${fault.column}` : fault.file;
}

export function coded(code, message) {
  return Object.assign(new Error(message), { code });
}
