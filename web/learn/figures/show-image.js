// Shows pixels in a canvas, also after a restart of the browser's graphics process, which leaves
// canvases black.
//
//     showImage(canvas, new ImageData(data, width, height));

const shown = new WeakMap(); // canvas -> its image

export function showImage(canvas, image) {
  const put = () => canvas.getContext('2d').putImageData(shown.get(canvas), 0, 0);
  if (!shown.has(canvas)) canvas.addEventListener('contextrestored', put);
  shown.set(canvas, image);
  put();
}
