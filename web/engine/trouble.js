// The error for everything that keeps a scene from being shown.
//
//     throw new Trouble('The scene could not be loaded', 'castle.json: the server answers 404');

// `faults` are the engine's: {file, pointer, line, column, row, character, found, expected}. `code`
// is one of element/faults.js.
export class Trouble extends Error {
  constructor(title, text, faults = [], code = faults.length > 0 ? 'scene' : 'engine') {
    super(text);
    this.title = title;
    this.faults = faults;
    this.code = code;
  }
}

// Whether the engine itself has crashed. Browsers without WebAssembly have no such error.
export function isEngineFailure(error) {
  return typeof WebAssembly === 'object' && error instanceof WebAssembly.RuntimeError;
}

// Wraps anything that was thrown in a Trouble.
export function asTrouble(error) {
  if (error instanceof Trouble) return error;
  console.error(error);
  if (isEngineFailure(error))
    return new Trouble(
      'The engine has stopped',
      `It cannot go on: ${error.message}. Reload the page.`,
    );
  return new Trouble(
    'Something went wrong',
    error instanceof Error ? error.message : String(error),
  );
}

// One error for the faults that the engine or sceneOfRows lists.
export function sceneFault(name, faults) {
  const count = faults.length === 1 ? 'One fault' : `${faults.length} faults`;
  return new Trouble(`${count} in ${name}`, 'It was read, but cannot be shown.', faults, 'scene');
}

// "castle.json:12:5", the form that editors and terminals recognise.
export function placeOf(fault) {
  return fault.line > 0 ? `${fault.file}:${fault.line}:${fault.column}` : fault.file;
}

// A message with the list of faults, for those who read no `faults`.
export function withList(message, faults) {
  return [
    message,
    ...faults.map(
      (fault) => `  ${placeOf(fault)}: found ${fault.found}, expected ${fault.expected}`,
    ),
  ].join('\n');
}

export function coded(code, message) {
  return Object.assign(new Error(message), { code });
}
