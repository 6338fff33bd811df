// Why a <ray-caster> cannot show its scene: the stable error codes, and what to do about each.
//
//     const {code, title, message, faults} = explain(error);      // anything that was thrown
//     throw faultOf('not-ready', 'hits() was called before the scene was there.');
//
// A code never changes its meaning; titles and messages may.

import { Trouble, asTrouble, placeOf } from '../engine/trouble.js';

// `means` says what happened, `remedy` what to do about it.
export const errorCodes = /* @__PURE__ */ Object.freeze({
  fetch: {
    title: 'A file could not be fetched',
    means:
      'The server of the engine or the scene does not answer, or answers with an error such as 404.',
    remedy: 'Check the address, and that the file is on that server.',
  },
  cors: {
    title: 'Another host does not share its file',
    means:
      'A file is on another origin, and its server does not let this page read it. A sandboxed iframe is another origin for every server.',
    remedy:
      "Let that server send the header Access-Control-Allow-Origin, or put the file on this page's host.",
  },
  mime: {
    title: 'A server sent the wrong kind of file',
    means:
      'The server answers with a web page, or sends a script with a type that browsers refuse.',
    remedy:
      'Check the address. If it is right, let the server send .js as text/javascript, and .wasm and .json unchanged.',
  },
  csp: {
    title: "This page's security policy blocks it",
    means: "The page's Content-Security-Policy blocks fetching or running the engine.",
    remedy:
      "Allow script-src 'self' 'wasm-unsafe-eval', and the hosts of the engine and the scene in connect-src.",
  },
  'no-webassembly': {
    title: 'This browser has no WebAssembly',
    means:
      'The browser does not support WebAssembly, or has it switched off, as in some strict security modes.',
    remedy: 'Use a current browser, or allow WebAssembly for this site.',
  },
  engine: {
    title: 'The engine has stopped',
    means: 'The engine did not start, ran out of memory, or failed with an internal error.',
    remedy: 'Reload the page. If it fails again, close other tabs or show fewer scenes at once.',
  },
  scene: {
    title: 'The scene has faults',
    means: 'The scene was read but has faults; each is listed with its place.',
    remedy: 'Fix each place listed.',
  },
  address: {
    title: 'An address or a view cannot be read',
    means: 'The address of a scene or a view is malformed, or no scene was given.',
    remedy: 'Correct it as the message says.',
  },
  tour: {
    title: 'The tour cannot be played',
    means: 'The recording cannot be fetched or read, or it belongs to another scene.',
    remedy: 'Check the address in tour. If the scene has changed, record the tour again.',
  },
  option: {
    title: 'Unknown option or value',
    means: 'The engine has no option of that name, or does not accept that value.',
    remedy: 'optionList lists all options and their values.',
  },
  'not-ready': {
    title: 'No scene has loaded yet',
    means: 'A method that needs a scene was called before the event ready.',
    remedy: 'Call it after await element.whenReady().',
  },
});

// An error with one of the codes, with that code's title.
export function faultOf(code, message, faults = []) {
  return new Trouble(errorCodes[code].title, message, faults, code);
}

// Returns ask(). Gives this code to an error that it throws without one.
export function orFault(code, ask) {
  try {
    return ask();
  } catch (error) {
    throw error.code === undefined ? faultOf(code, error.message) : error;
  }
}

// What a page shows and the event `error` carries. Adds `place` to each fault: "castle.json:12:5".
export function explain(error) {
  const { code, title, message, faults } = asTrouble(codedError(error));
  return {
    code,
    title,
    message: `${sentence(message)} ${errorCodes[code].remedy}`,
    faults: faults.map((fault) => ({ ...fault, place: placeOf(fault) })),
  };
}

function codedError(error) {
  if (error instanceof Trouble) return error;
  const isOutOfMemory = error instanceof RangeError && /memory|allocat/i.test(error.message);
  if (isOutOfMemory) return faultOf('engine', `There is not enough memory: ${error.message}`);
  // A script with its own copy of Trouble may have thrown it.
  if (error instanceof Error && Object.hasOwn(errorCodes, error.code)) {
    return new Trouble(
      error.title ?? errorCodes[error.code].title,
      error.message,
      error.faults,
      error.code,
    );
  }
  return error;
}

function sentence(text) {
  return /[.!?]\)?$/.test(text.trim()) ? text.trim() : `${text.trim()}.`;
}
