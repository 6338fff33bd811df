// Draws a kind of block as a small cube, seen from a corner above: its top, its south and its east,
// behind them the other faces. A block that shows nothing is an outline.
// Takes a blueprint and pictures; paints a canvas. Knows no document.
//
//     paintBlock(canvas, blueprint, pictures);
//     paintWhole(canvas, image);                  // a thing's picture

import { extentOf, kFaces, textureOf, waterOf } from './shapes.js';

const kShade = { top: 0, south: 0.16, east: 0.36, bottom: 0.36, north: 0.16, west: 0.36 };
const kOutline = '#9a8d80';

export function paintBlock(canvas, blueprint, pictures) {
  const context = canvas.getContext('2d');
  const size = canvas.width;
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, size, size);
  const { low, high, west, north, east, south } = extentOf(blueprint);
  // Where a corner of the cell lies: u east, v south, h up, from 0 to 1.
  const half = size / 2;
  const point = (u, v, h) => [
    half + (u - v) * half * 0.86,
    size * 0.98 - half * 0.5 * (2 - u - v) - h * size * 0.5,
  ];
  if (kFaces.every((face) => isClear(textureOf(blueprint, face), pictures))) outline();
  paint('bottom', point(west, north, low), point(east, north, low), point(west, south, low));
  paint('north', point(west, north, high), point(east, north, high), point(west, north, low));
  paint('west', point(west, north, high), point(west, south, high), point(west, north, low));
  paint('south', point(west, south, high), point(east, south, high), point(west, south, low));
  paint('east', point(east, south, high), point(east, north, high), point(east, south, low));
  paint('top', point(west, north, high), point(east, north, high), point(west, south, high));

  function outline() {
    context.strokeStyle = kOutline;
    context.lineWidth = Math.max(1, size / 32);
    context.beginPath();
    for (const [first, ...others] of [
      [point(west, north, high), point(east, north, high), point(east, south, high)],
      [point(west, north, high), point(west, south, high), point(east, south, high)],
      [point(west, south, high), point(west, south, low), point(east, south, low)],
      [point(east, south, high), point(east, south, low), point(east, north, low)],
      [point(east, north, high), point(east, north, low)],
    ]) {
      context.moveTo(...first);
      for (const other of others) context.lineTo(...other);
    }
    context.stroke();
  }

  // A picture on the parallelogram of three corners.
  function paint(face, corner, right, down) {
    const name = textureOf(blueprint, face);
    const image = name === null ? null : pictures.imageOf(name);
    context.setTransform(
      right[0] - corner[0],
      right[1] - corner[1],
      down[0] - corner[0],
      down[1] - corner[1],
      corner[0],
      corner[1],
    );
    context.imageSmoothingEnabled = false;
    if (image === null) {
      const colour = name === null ? waterOf(blueprint) : '#6b625a';
      if (colour === null) return;
      context.fillStyle = colour;
      context.fillRect(0, 0, 1, 1);
    } else {
      context.drawImage(image, 0, 0, 1, 1);
    }
    context.fillStyle = `rgb(21 19 28 / ${kShade[face]})`;
    context.globalCompositeOperation = 'source-atop';
    context.fillRect(0, 0, 1, 1);
    context.globalCompositeOperation = 'source-over';
  }
}

// Without a picture, or of one that one looks through everywhere.
function isClear(name, pictures) {
  return name === null || (pictures.imageOf(name) !== null && pictures.meanOf(name) === null);
}

// A part of a world (parts.js), each block as a small cube in its colour.
export function paintPart(canvas, { width, depth, levels, cells, colours = {} }) {
  const context = canvas.getContext('2d');
  const size = canvas.width;
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, size, size);
  // A cube is two steps wide, a step and a half high.
  const step = Math.min(size / (width + depth), size / ((width + depth) / 2 + levels));
  const top = (size - step * ((width + depth) / 2 + levels)) / 2;
  const left = (size - step * (width + depth)) / 2;
  const ordered = [...cells].sort((one, other) => depthOf(one) - depthOf(other));
  for (const { level, x, y, sign } of ordered) {
    const across = left + (x - y + depth) * step;
    const down = top + ((x + y) / 2 + levels - level - 1) * step;
    const half = step / 2;
    const face = (shade, ...corners) => {
      context.beginPath();
      for (const [right, below] of corners) context.lineTo(across + right, down + below);
      context.closePath();
      for (const colour of [colours[sign] ?? '#8a8078', `rgb(21 19 28 / ${shade})`]) {
        context.fillStyle = colour;
        context.fill();
      }
    };
    face(kShade.south, [-step, half], [0, step], [0, 2 * step], [-step, step + half]);
    face(kShade.east, [step, half], [0, step], [0, 2 * step], [step, step + half]);
    face(kShade.top, [0, 0], [step, half], [0, step], [-step, half]);
  }
}

const depthOf = ({ level, x, y }) => x + y + level;

// A whole picture, as large as it fits.
export function paintWhole(canvas, image) {
  if (image === null) return;
  const context = canvas.getContext('2d');
  const { width, height } = canvas;
  const scale = Math.min(width / image.width, height / image.height);
  const [across, down] = [image.width * scale, image.height * scale];
  context.clearRect(0, 0, width, height);
  context.imageSmoothingEnabled = false;
  context.drawImage(image, (width - across) / 2, height - down, across, down);
}
