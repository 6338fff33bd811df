// Chooses between the engine's two builds: the one with SIMD wherever the browser supports it.
//
//     chooseBuild('auto')      // 'simd' or 'scalar'

// The smallest module that uses SIMD: (func (result v128) i32.const 0 i8x16.splat i8x16.popcnt).
const kSimdModule = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15,
  253, 98, 11,
]);

export function browserHasWebAssembly() {
  return typeof WebAssembly === 'object' && typeof WebAssembly.validate === 'function';
}

function browserHasSimd() {
  return WebAssembly.validate(kSimdModule);
}

// `kind` is 'simd', 'scalar', or 'auto' for the one that suits the browser.
export function chooseBuild(kind) {
  return kind === 'auto' ? (browserHasSimd() ? 'simd' : 'scalar') : kind;
}
