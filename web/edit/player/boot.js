// The first script of the one HTML file: unpacks the player and starts it. It is a part of the page
// itself, as browsers run no script file of a page from a disk.
//
//     await slicecastPart('program')       // the bytes of a part of this page

import { bytesOfDense } from '../files/dense-text.js';

globalThis.slicecastPart = async (id) => {
  const packed = bytesOfDense(document.getElementById(id).textContent);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  return new Uint8Array(await new Response(stream).arrayBuffer(), 1); // after a zero
};

globalThis.slicecastPart('player').then(
  (bytes) => {
    const script = document.createElement('script');
    script.type = 'module';
    script.textContent = new TextDecoder().decode(bytes);
    document.body.append(script);
  },
  () => {
    document.getElementById('told').textContent =
      'This browser is too old for this file: it cannot unpack it. Open it in a newer one.';
  },
);
