// Instantiates the engine's WebAssembly with the functions that it imports: src/wasm/bindings.h for
// JavaScript. Under Node it calls only the clock.
//
//     const module = await createModule(program, {canvas, openCanvas, onSlicecast(event) {}})
//     module._slicecast_NAME(...);      module.HEAPU8;      module.UTF8ToString(at);
//
// `program` is compiled and may be instantiated any number of times; openCanvas is that of
// engine-canvas.js. Keys for which `takesKey(code)` is false are left to the page.
//
// A program may lack its later part: what no first picture needs (tools/split-program.mjs). Then
// `later` has `program`, that part compiled or null, and readNow(), which returns it at once. It is
// put in by `await module.complete()`, or when one of its functions is called.

import { Trouble } from './trouble.js';

const kPageBytes = 65536;

export async function createModule(program, page = {}) {
  const { module, imports, take, start } = prepare(program, page);
  take(await WebAssembly.instantiate(program, imports));
  if (page.later?.program) await module.complete();
  return start();
}

// The same at once, with the memory of another module of that program: it goes on where that one
// was. Only where the browser can compile at once (engine-files.js).
export function createModuleNow(program, page, memory) {
  const { module, imports, take, start, completeNow } = prepare(program, page);
  take(new WebAssembly.Instance(program, imports));
  if (page.later?.program) completeNow(page.later.program);
  start();
  const lacking = memory.length - module.HEAPU8.length;
  if (lacking > 0) module._memory.grow(Math.ceil(lacking / kPageBytes));
  module.HEAPU8.set(memory);
  return module;
}

function prepare(
  program,
  { canvas = null, openCanvas, onSlicecast = () => {}, takesKey = () => true, later = null },
) {
  const decoder = new TextDecoder();
  const module = {
    isComplete: later === null,
    // A new view whenever memory has grown.
    get HEAPU8() {
      if (bytes.buffer !== exports.memory.buffer) bytes = new Uint8Array(exports.memory.buffer);
      return bytes;
    },
    UTF8ToString(at) {
      const { HEAPU8 } = module;
      return at === 0 ? '' : decoder.decode(HEAPU8.subarray(at, HEAPU8.indexOf(0, at)));
    },
    get awaitsFrame() {
      return forgetFrame !== null;
    },
  };
  let exports;
  let bytes = new Uint8Array();
  let screen = null;
  let forgetFrame = null; // the requested one

  const drawFrame = (time) => {
    forgetFrame = null;
    const begin = performance.now();
    exports.slicecastFrame(time);
    onSlicecast('animation', { time, milliseconds: performance.now() - begin });
  };

  // src/app/page_shell.cpp
  const page = {
    openCanvas(code, codeBytes) {
      if (canvas === null) return 0;
      const writeCode = (text) => {
        const { written } = new TextEncoder().encodeInto(
          text,
          module.HEAPU8.subarray(code, code + codeBytes - 1),
        );
        module.HEAPU8[code + written] = 0;
      };
      screen = openCanvas(canvas, exports, { writeCode, takesKey });
      return 1;
    },
    closeCanvas() {
      screen.close();
      screen = null;
    },
    now: () => performance.now(),
    showPixels: (at, width, height) => screen.show(module.HEAPU8.buffer, at >>> 0, width, height),
    askForFrame(withScreen) {
      const frame = withScreen
        ? requestAnimationFrame(drawFrame)
        : setTimeout(() => drawFrame(performance.now()));
      forgetFrame = () => (withScreen ? cancelAnimationFrame : clearTimeout)(frame);
    },
    forgetFrame() {
      forgetFrame();
      forgetFrame = null;
    },
    leaveCanvas: () => canvas.blur(),
    tell: (news, yes) => onSlicecast(module.UTF8ToString(news), yes !== 0),
    tellShown(moved) {
      if (moved) onSlicecast('view', true);
      onSlicecast('frame', true);
    },
    tellPortal: (from, to) =>
      onSlicecast('portal', { from: module.UTF8ToString(from), to: module.UTF8ToString(to) }),
    tellRates: (framesPerSecond, drawMilliseconds, longestMilliseconds) =>
      onSlicecast('frames', { framesPerSecond, drawMilliseconds, longestMilliseconds }),
    tellSize(width, height) {
      canvas.width = width;
      canvas.height = height;
    },
    tellHits: (width, height, column) => onSlicecast('hits', { width, height, column }),
  };
  const system = {
    proc_exit(status) {
      throw new WebAssembly.RuntimeError(`the engine exited (${status})`);
    },
  };

  // The engine grows its memory by just what it needs; growing it a fifth further makes that rare.
  const growFurther = () => {
    try {
      exports.memory.grow(Math.floor(exports.memory.buffer.byteLength / kPageBytes / 5));
    } catch {
      // No more memory: the engine has what it needs for now.
    }
  };
  // A browser may have kept the first part of one release, and fetch the later part of the next.
  const fitting = (part) => {
    if (wholeOf(part) === wholeOf(program)) return part;
    throw new Trouble(
      'The engine could not be loaded',
      'Its two parts are of different releases. Reload the page.',
    );
  };
  const completeNow = (part) => {
    new WebAssembly.Instance(fitting(part), { primary: exports });
    module.isComplete = true;
  };
  // Stands in for the functions of the later part, by their place in the table of functions.
  const missing = new Proxy(
    {},
    {
      get:
        (_, place) =>
        (...values) => {
          if (later === null) throw new Error("the program's later part is missing");
          if (!module.isComplete) completeNow(later.readNow());
          return exports.__indirect_function_table.get(Number(place))(...values);
        },
    },
  );
  // src/wasm/imports.txt lists what a program may ask for.
  const imports = {
    page,
    wasi_snapshot_preview1: system,
    env: { emscripten_notify_memory_growth: growFurther },
    placeholder: missing,
  };
  module.complete = async () => {
    if (module.isComplete) return;
    await WebAssembly.instantiate(fitting(later.program), { primary: exports });
    module.isComplete = true;
  };
  // Draws now instead of in the requested frame.
  module.frameNow = (time) => {
    forgetFrame?.();
    drawFrame(time);
  };
  const take = (instance) => {
    ({ exports } = instance);
  };
  const start = () => {
    exports._initialize();
    for (const [name, value] of Object.entries(exports)) module[`_${name}`] = value;
    return module;
  };
  return { module, imports, take, start, completeNow };
}

// Says which program a part was split from.
function wholeOf(part) {
  return new Uint8Array(WebAssembly.Module.customSections(part, 'whole')[0]).join();
}
