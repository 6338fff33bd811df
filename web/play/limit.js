// The limit of tools/bench, in the page: how long it takes to fill a frame with as many texels as
// the engine does, but without a world.
//
//     const limit = await loadLimit(1280, 720);      null without WebAssembly SIMD or the file
//     limit.time();                                  milliseconds per frame

const kFrames = 4; // timed together, because browsers' clocks are coarse

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
      // The first frame fills the caches, as the previous picture does for the engine.
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
