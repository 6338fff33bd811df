// What can keep a <ray-caster> from showing its scene: the stable codes, and what to do about each.
//
//     const {code, title, message, faults} = explain(error);      // of anything that was thrown
//     throw faultOf('not-ready', 'hits() was called before the scene was there.');
//
// A code never changes its meaning; titles and messages may.

import { Trouble, asTrouble, placeOf } from '../engine/trouble.js';

// `means` says what has happened, `remedy` what to do about it.
export const errorCodes = /* @__PURE__ */ Object.freeze({
  fetch: {
    title: 'A file could not be fetched',
    means:
      'The server of the engine or the scene does not answer, or it answers with an error such as 404.',
    remedy: 'Check the address, and that the file is on that server.',
  },
  cors: {
    title: 'Another host does not share its file',
    means:
      'A file lies on another origin, whose server does not let this page read it. A sandboxed iframe counts as another origin everywhere.',
    remedy:
      "Let its server send the header Access-Control-Allow-Origin, or put the file on this page's own host.",
  },
  mime: {
    title: 'A server sends something else',
    means:
      'An address is answered by a web page, or a script comes with a type that browsers refuse.',
    remedy:
      'Check the address; if it is right, let the server send .js as text/javascript and .wasm and .json as they are.',
  },
  csp: {
    title: "This page's rules forbid it",
    means:
      "The page's Content-Security-Policy keeps the engine from being fetched or from running.",
    remedy:
      "Allow it: script-src 'self' 'wasm-unsafe-eval', and in connect-src the hosts of the engine and the scene.",
  },
  'no-webassembly': {
    title: 'This browser has no WebAssembly',
    means:
      'The browser cannot run WebAssembly, or it is switched off, as in some strict security modes.',
    remedy: 'Use a current browser, or allow WebAssembly for this site.',
  },
  engine: {
    title: 'The engine has stopped',
    means: 'The engine does not start, has run out of memory, or has met an error of its own.',
    remedy: 'Load the page again; if it comes back, close other tabs or show fewer scenes at once.',
  },
  scene: {
    title: 'The scene has faults',
    means: 'The scene was read but cannot be shown; each of its faults is listed with its place.',
    remedy: 'Mend each place that is listed.',
  },
  address: {
    title: 'An address or a view cannot be read',
    means: 'An address of a scene or a view is not written as it must be, or there is no scene.',
    remedy: 'Write it as the message says.',
  },
  tour: {
    title: 'The tour cannot be played',
    means: 'The recording cannot be fetched or read, or it belongs to another scene.',
    remedy: 'Check the address in tour, and record it anew if the scene has changed.',
  },
  option: {
    title: 'There is no such option or value',
    means: 'The engine knows no option of that name, or does not take that value.',
    remedy: 'optionList names all options and their values.',
  },
  'not-ready': {
    title: 'There is no scene yet',
    means: 'A method was called that needs a scene, before the event ready.',
    remedy: 'Call it after await element.whenReady().',
  },
});

// An error with one of the codes, titled by the table.
export function faultOf(code, message, faults = []) {
  return new Trouble(errorCodes[code].title, message, faults, code);
}

// What `ask` gives; an error of it without a code is one with this code.
export function orFault(code, ask) {
  try {
    return ask();
  } catch (error) {
    throw error.code === undefined ? faultOf(code, error.message) : error;
  }
}

// What a page shows and the event `error` carries. Each fault has, besides what the engine says of
// it, `place`: "castle.json:12:5".
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
  // Of a script with a copy of Trouble of its own, too.
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
