// The limit that tools/bench measures by, in the page: how long a frame as full as the engine's takes
// with no world behind it.
//
//     const limit = await loadLimit(1280, 720);      null without WebAssembly SIMD, or without the file
//     limit.time();                                  milliseconds a frame

const kFrames = 4; // timed as one: clocks of browsers are coarse

export async function loadLimit(width, height) {
  try {
    const answer = await fetch(new URL('limit.wasm', import.meta.url));
    if (!answer.ok) return null;
    const program = await WebAssembly.compile(await answer.arrayBuffer());
    const imports = {};
    for (const { module, name } of WebAssembly.Module.imports(program))
      (imports[module] ??= {})[name] = () => 0;
    const { exports } = await WebAssembly.instantiate(program, imports);
    exports._initialize();
    exports.setSize(width, height);
    return {
      // The first frame brings all into the caches, as the picture before did for the engine.
      time() {
        exports.drawFrames(1);
        const begin = performance.now();
        exports.drawFrames(kFrames);
        return (performance.now() - begin) / kFrames;
      },
    };
  } catch {
    return null;
  }
}
