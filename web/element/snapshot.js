// The view as an image file.
//
//     const blob = await snapshotOf(engine, {width: 1280, height: 800, type: 'image/png'});

import { kLargestSide } from './stage.js';

export function checkSize(method, { width, height }) {
  for (const [name, side] of Object.entries({ width, height })) {
    if (!Number.isInteger(side) || side < 1 || side > kLargestSide)
      throw new RangeError(
        `${method}: found ${name} ${side}, expected a whole number from 1 to ${kLargestSide}.`,
      );
  }
  return { width, height };
}

export async function snapshotOf(engine, { width, height, type, ...others }) {
  for (const name of Object.keys(others))
    throw new RangeError(`snapshot: found ${name}, expected some of width, height, type.`);
  checkSize('snapshot', { width, height });
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  canvas.getContext('2d', { alpha: false }).putImageData(engine.drawOnce(width, height), 0, 0);
  const blob = await new Promise((resolve) => canvas.toBlob(resolve, type));
  if (blob === null)
    throw new Error(`snapshot: this browser cannot make a picture of ${width} x ${height} pixels.`);
  if (blob.type !== type)
    throw new Error(
      `snapshot: found type ${type}, expected an image type that this browser writes, such as image/png.`,
    );
  return blob;
}
