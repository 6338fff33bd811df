// Fetches the engine: the build with SIMD where the browser has it, else the one without. What is
// compiled here serves any number of engines.
//
//     const files = await fetchEngine({kind: 'auto', onBytes(loaded, total) {...}});
//     const engine = await Engine.create({files, canvas});

import { browserHasWebAssembly, chooseBuild } from './builds.js';
import { openCanvas } from './engine-canvas.js';
import { fetchResponse, listenForViolations, readBody } from './fetch-bytes.js';
import { kHome, reachable } from './home.js';
import { Trouble, coded } from './trouble.js';

// The addresses stand here as literals: that is how bundlers find the files.
const kBuilds = {
  simd: () => new URL('./slicecast-simd.wasm', import.meta.url),
  scalar: () => new URL('./slicecast-scalar.wasm', import.meta.url),
};

// `total` is 0 while it is unknown. Throws a Trouble.
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
    // Compiled while it comes, if the server names its type; browsers then also keep the machine
    // code for the next visit. The copy tells how far it is.
    const isNamed = /^application\/wasm$/i.test(response.headers.get('Content-Type') ?? '');
    const copy = isNamed ? response.clone() : response;
    const streamed = isNamed ? WebAssembly.compileStreaming(response) : null;
    streamed?.catch(() => {}); // it may fail before it is waited for
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

// A server that answers every address with a page of its own is a common way to fail.
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
        'The page does not let the engine run',
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
    `${address}: ${error.message}. Bundlers have to copy it: see "With a bundler" in slicecast's README.`,
    [],
    error.code,
  );
}
