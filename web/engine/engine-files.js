// Fetches and compiles the engine, with SIMD where the browser supports it. One compiled program
// serves any number of engines.
//
//     const files = await fetchEngine({kind: 'auto', onBytes(loaded, total) {...}});
//     const engine = await Engine.create({files, canvas});

import { browserHasWebAssembly, chooseBuild } from './builds.js';
import { openCanvas } from './engine-canvas.js';
import { fetchResponse, listenForViolations, readBody } from './fetch-bytes.js';
import { kHome, reachable } from './home.js';
import { Trouble, coded } from './trouble.js';

// Literal addresses, so that bundlers find the files.
const kBuilds = {
  simd: () => new URL('./slicecast-simd.wasm', import.meta.url),
  scalar: () => new URL('./slicecast-scalar.wasm', import.meta.url),
};
// What no first picture needs is a part of its own (tools/split-program.mjs). Browsers without SIMD
// may also lack what such a part takes.
const kLater = {
  simd: () => new URL('./slicecast-simd-later.wasm', import.meta.url),
};

// Returns {kind, program, later, openCanvas, canCompileNow} for Engine.create; `later` is a
// LaterPart, or null. onBytes counts bytes; `total` is 0 while it is unknown. Throws a Trouble.
export async function fetchEngine({ kind = 'auto', onBytes = () => {} } = {}) {
  if (!browserHasWebAssembly()) {
    throw new Trouble(
      'This browser has no WebAssembly',
      'The engine is a WebAssembly program.',
      [],
      'no-webassembly',
    );
  }
  const chosen = chooseBuild(kind);
  const address = reachable(kBuilds[chosen], `engine/slicecast-${chosen}.wasm`, kHome);
  const canCompileNow = findCompileNow();
  const later = Object.hasOwn(kLater, chosen)
    ? new LaterPart(reachable(kLater[chosen], `engine/slicecast-${chosen}-later.wasm`, kHome).href)
    : null;
  const [program] = await Promise.all([
    compileProgram(address.href, onBytes),
    canCompileNow ? null : later?.load(),
  ]);
  return { kind: chosen, program, later, openCanvas, canCompileNow };
}

class LaterPart {
  program = null; // once it has loaded
  #address;
  #loading = null;

  constructor(address) {
    this.#address = address;
  }

  // Throws a Trouble; then it may be called again.
  async load() {
    this.#loading ??= compileProgram(this.#address, () => {});
    try {
      this.program ??= await this.#loading;
    } catch (error) {
      this.#loading = null;
      throw error;
    }
  }

  // For the rare first picture that needs it after all: the page stands still meanwhile.
  readNow() {
    if (this.program !== null) return this.program;
    const request = new XMLHttpRequest();
    request.open('GET', this.#address, false);
    request.overrideMimeType('text/plain; charset=x-user-defined'); // each byte as a character
    request.send();
    if (request.status !== 200)
      throw cannotLoad(this.#address, coded('fetch', `the server answers ${request.status}`));
    const bytes = Uint8Array.from(request.response, (character) => character.charCodeAt(0));
    checkBeginning(bytes);
    return (this.program = new WebAssembly.Module(bytes));
  }
}

// Chromium before 115 refuses to compile more than 4 KB while the page waits.
function findCompileNow() {
  const bytes = new Uint8Array(5010); // a program with nothing but 5,000 bytes of comment
  bytes.set([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 0, 0x87, 0x27]);
  try {
    new WebAssembly.Module(bytes);
    return true;
  } catch {
    return false;
  }
}

async function compileProgram(address, onBytes) {
  const response = await fetchResponse(address).catch((error) => {
    throw cannotLoad(address, error);
  });
  const violations = listenForViolations();
  try {
    // Compiles while downloading if the server sends the right type; browsers then also cache the
    // machine code. The copy is read to report progress.
    const isNamed = /^application\/wasm$/i.test(response.headers.get('Content-Type') ?? '');
    const copy = isNamed ? response.clone() : response;
    const streamed = isNamed ? WebAssembly.compileStreaming(response) : null;
    streamed?.catch(() => {}); // it may fail before anything awaits it
    const bytes = await readBody(copy, onBytes);
    checkBeginning(bytes);
    return await (streamed ?? WebAssembly.compile(bytes));
  } catch (error) {
    throw typeof error.code === 'string'
      ? cannotLoad(address, error)
      : refusal(address, error, violations);
  } finally {
    violations.stop();
  }
}

// Throws unless the bytes begin like a program: many servers answer a wrong address with a page.
function checkBeginning(bytes) {
  if (
    bytes.length >= 8 &&
    bytes[0] === 0 &&
    bytes[1] === 0x61 &&
    bytes[2] === 0x73 &&
    bytes[3] === 0x6d
  )
    return;
  const beginning = new TextDecoder().decode(bytes.subarray(0, 24)).replace(/\s+/g, ' ').trim();
  throw coded('mime', `found "${beginning}", expected a WebAssembly program`);
}

function refusal(address, error, { refused }) {
  const isPolicy =
    refused.some((one) => one.address === 'wasm-eval') ||
    /content security policy|unsafe-eval/i.test(error.message);
  return isPolicy
    ? new Trouble(
        'The page blocks the engine',
        'Its Content-Security-Policy does not allow WebAssembly.',
        [],
        'csp',
      )
    : new Trouble(
        'The engine does not run here',
        `This browser refuses ${address}: ${error.message}`,
        [],
        'engine',
      );
}

function cannotLoad(address, error) {
  return new Trouble(
    'The engine could not be loaded',
    `${address}: ${error.message}. Bundlers must copy it: see "With a bundler" in slicecast's README.`,
    [],
    error.code,
  );
}
