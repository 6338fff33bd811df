// Decodes PNG files to RGBA bytes, exactly: a canvas would round colours of see-through texels.
//
//     const { width, height, data } = decodePng(bytes);

import { convertIndexedToRgb, decode } from 'fast-png';

export function decodePng(bytes) {
  const image = decode(bytes);
  const { width, height } = image;
  const { data, channels } = image.palette
    ? { data: convertIndexedToRgb(image), channels: image.palette[0].length }
    : image;
  const pixels = new Uint8ClampedArray(4 * width * height);
  const isGrey = channels < 3;
  const hasAlpha = channels === 2 || channels === 4;
  for (let pixel = 0; pixel < width * height; ++pixel) {
    const from = channels * pixel;
    for (let channel = 0; channel < 3; ++channel)
      pixels[4 * pixel + channel] = data[from + (isGrey ? 0 : channel)];
    pixels[4 * pixel + 3] = hasAlpha ? data[from + channels - 1] : 255;
  }
  return { width, height, data: pixels };
}
