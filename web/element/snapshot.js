// The view as an image file.
//
//     const blob = await encoded(imageData, {type: 'image/png'});

export async function encoded(image, { type, ...others }) {
  for (const name of Object.keys(others))
    throw new RangeError(`snapshot: found ${name}, expected some of width, height, type.`);
  const { width, height } = image;
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  canvas.getContext('2d', { alpha: false }).putImageData(image, 0, 0);
  const blob = await new Promise((resolve) => canvas.toBlob(resolve, type));
  if (blob === null)
    throw new Error(`snapshot: this browser cannot make a picture of ${width} x ${height} pixels.`);
  if (blob.type !== type)
    throw new Error(
      `snapshot: found type ${type}, expected an image type that this browser writes, such as image/png.`,
    );
  return blob;
}
