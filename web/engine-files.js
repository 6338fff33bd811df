// Fetches the engine: the build with SIMD where the browser has it, else the one without. What is compiled here serves any number of engines.
//
//     const files = await fetchEngine({kind: 'auto', onBytes(loaded, total) {...}});
//     const engine = await Engine.create({files, canvas});

import { Trouble } from './trouble.js';

// The smallest module that uses SIMD: (func (result v128) i32.const 0 i8x16.splat i8x16.popcnt).
const kSimdModule = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
]);

const kFolder = new URL('engine/', import.meta.url);

export function browserHasSimd() {
  return WebAssembly.validate(kSimdModule);
}

// `kind` is 'simd', 'scalar' or 'auto'. `total` is 0 while it is unknown. Throws a Trouble.
export async function fetchEngine({ kind = 'auto', onBytes = () => {} } = {}) {
  const chosen = kind === 'auto' ? (browserHasSimd() ? 'simd' : 'scalar') : kind;
  const glueAddress = new URL(`slicecast-${chosen}.js`, kFolder).href;
  const programAddress = new URL(`slicecast-${chosen}.wasm`, kFolder).href;
  const [glue, program] = await Promise.all([importGlue(glueAddress), compileProgram(programAddress, onBytes)]);
  return { kind: chosen, createModule: glue.default, program };
}

async function importGlue(address) {
  try {
    return await import(address);
  } catch (error) {
    throw new Trouble('The engine could not be loaded', `${address} is missing, or the server does not send it as JavaScript. (${error.message})`);
  }
}

async function compileProgram(address, onBytes) {
  const bytes = await fetchBytes(address, onBytes).catch((error) => {
    throw new Trouble('The engine could not be loaded', `${address}: ${error.message}`);
  });
  // A server that answers every address with a page of its own is a common way to fail.
  if (bytes.length < 8 || bytes[0] !== 0 || bytes[1] !== 0x61 || bytes[2] !== 0x73 || bytes[3] !== 0x6d) {
    const beginning = new TextDecoder().decode(bytes.subarray(0, 24)).replace(/\s+/g, ' ').trim();
    throw new Trouble('The engine could not be loaded', `${address}: found "${beginning}", expected a WebAssembly program.`);
  }
  try {
    return await WebAssembly.compile(bytes);
  } catch (error) {
    throw new Trouble('The engine does not run here', `This browser refuses ${address}: ${error.message}`);
  }
}

// The bytes behind an address, with their number as they come. Throws an Error that says why there are none.
export async function fetchBytes(address, onBytes = () => {}) {
  let response;
  try {
    response = await fetch(address);
  } catch {
    throw new Error('the server does not answer');
  }
  if (!response.ok) throw new Error(`the server answers ${response.status} ${response.statusText}`.trim());
  // A compressed answer's length is not the length of what arrives.
  const total = response.headers.has('Content-Encoding') ? 0 : Number(response.headers.get('Content-Length') ?? 0);
  if (response.body === null) return new Uint8Array(await response.arrayBuffer());

  const chunks = [];
  let loaded = 0;
  const reader = response.body.getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    chunks.push(value);
    loaded += value.length;
    onBytes(loaded, Math.max(total, loaded));
  }
  const bytes = new Uint8Array(loaded);
  let at = 0;
  for (const chunk of chunks) {
    bytes.set(chunk, at);
    at += chunk.length;
  }
  return bytes;
}
