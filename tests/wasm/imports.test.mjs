// The engine may only import the functions that src/wasm/imports.txt names. Here: the shipped
// programs import exactly those, and the build's check fails for any other.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { flavours, root } from './load.mjs';

const list = join(root, 'src/wasm/imports.txt');
const listed = readFileSync(list, 'utf8')
  .split('\n')
  .filter((line) => line !== '' && !line.startsWith('#'));

for (const flavour of flavours) {
  test(`the ${flavour} program asks for what is listed`, () => {
    const program = new WebAssembly.Module(
      readFileSync(join(root, `build/web/engine/slicecast-${flavour}.wasm`)),
    );
    // Placeholders are functions of the program's later part
    const asked = WebAssembly.Module.imports(program)
      .filter(({ module }) => module !== 'placeholder')
      .map(({ module, name }) => `${module} ${name}`);
    for (const line of asked) assert.ok(listed.includes(line), line);
    // A newer Emscripten may need fewer system functions; those of the page are all needed.
    for (const line of listed.filter((each) => each.startsWith('page ')))
      assert.ok(asked.includes(line), `nothing asks for ${line}`);
  });
}

// A program that does nothing but import one function.
function importing(module, name) {
  const text = (string) => [string.length, ...Buffer.from(string)];
  const imported = [1, ...text(module), ...text(name), 0, 0];
  const header = [0x00, 0x61, 0x73, 0x6d, 1, 0, 0, 0];
  return new Uint8Array([...header, 1, 4, 1, 0x60, 0, 0, 2, imported.length, ...imported]);
}

test('a build ends that asks for more than the page has', (t) => {
  const folder = mkdtempSync(join(tmpdir(), 'slicecast-imports-'));
  t.after(() => rmSync(folder, { recursive: true }));
  const file = join(folder, 'program.wasm');
  const check = (module, name) => {
    writeFileSync(file, importing(module, name));
    return spawnSync('node', [join(root, 'tools/check-imports.mjs'), file, list], {
      encoding: 'utf8',
    });
  };
  const system = 'wasi_snapshot_preview1';
  for (const [module, name] of [
    [system, 'clock_time_get'], // clock(), time(), emscripten_get_now()
    [system, 'fd_write'], // printf()
    [system, 'environ_get'], // getenv()
    ['env', 'emscripten_asm_const_int'], // EM_ASM
    ['env', 'neverDefined'],
    ['page', 'neverGiven'],
  ]) {
    const { status, stderr } = check(module, name);
    assert.equal(status, 1, name);
    assert.match(stderr, new RegExp(`program\\.wasm asks for what no page has: ${module} ${name}`));
  }
  assert.equal(check('page', 'now').status, 0);
});
