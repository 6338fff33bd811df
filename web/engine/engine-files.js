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

// Returns {kind, program, openCanvas} for Engine.create. onBytes counts bytes; `total` is 0 while
// it is unknown. Throws a Trouble.
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
  return { kind: chosen, program: await compileProgram(address.href, onBytes), openCanvas };
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
