// Draws parts of a section on a canvas whose place 0, 0 is the floor at its beginning.
// Takes a context, pixels a unit and the parts (section.js). Changes nothing.

import { cellIn } from './section.js';

const kLine = 'rgb(21 19 28 / 0.7)';
const kPortal = '#b58cf0';
const kCeiling = '#d1c3aa';
const kWater = 0.6; // of water is seen
const kOutlineFrom = 7; // pixels a unit
const kFaint = 0.3; // what is drawn so, or fainter, has no outline

export function drawBlock(context, scale, { along, level, blueprint, profile }, colour, alpha) {
  const { from, to, bottom, top } = profile;
  const [first, last] = [(along + from) * scale, (along + to) * scale];
  const at = (height) => -(level + height) * scale;
  line(context, [
    [first, at(bottom[0])],
    [last, at(bottom[1])],
    [last, at(top[1])],
    [first, at(top[0])],
  ]);
  context.closePath();
  context.globalAlpha = alpha * (blueprint.water === undefined ? 1 : kWater);
  context.fillStyle = colour;
  context.fill();
  if (alpha > kFaint && scale >= kOutlineFrom) {
    context.globalAlpha = alpha;
    context.strokeStyle = kLine;
    context.lineWidth = 1;
    context.stroke();
  }
  context.globalAlpha = 1;
}

// Where its tiles are open there is none.
export function drawCeiling(context, scale, scene, map, section, length) {
  const { ceiling } = scene.value.maps[map];
  if (ceiling === undefined) return;
  const top = -ceiling.height * scale;
  context.fillStyle = kCeiling;
  for (let along = 0; along < length; ++along) {
    const { x, y } = cellIn(section, along, 0);
    const isOpen = ceiling.tiles !== undefined && scene.sign(map, 'ceiling', x, y) === ' ';
    if (!isOpen) context.fillRect(along * scale, top - 3, scale + 0.5, 3);
  }
  drawLabel(context, `ceiling ${ceiling.height}`, length * scale, top - 12, 'right');
}

// As tall as it stands in the world.
export function drawSprite(context, scale, image, along, { z = 0, height, width }) {
  const across = width ?? (height * image.width) / image.height;
  const [left, top] = [along - across / 2, -z - height];
  context.drawImage(image, left * scale, top * scale, across * scale, height * scale);
}

export function drawPortal(context, scale, { along, level, side }) {
  const [left, right] = [along * scale, (along + 1) * scale];
  const [low, high] = [-level * scale, -(level + 1) * scale];
  const [a, b, c, d] = [
    [left, low],
    [left, high],
    [right, high],
    [right, low],
  ];
  const all = [a, b, c, d, a];
  line(context, { from: [a, b], to: [c, d], top: [b, c], bottom: [a, d] }[side] ?? all);
  context.strokeStyle = kPortal;
  context.lineWidth = 3;
  context.stroke();
}

export function line(context, points) {
  context.beginPath();
  points.forEach(([x, y], index) => {
    if (index === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  });
}

export function drawLabel(context, text, x, y, align) {
  context.font = "12px 'Segoe UI', Ubuntu, system-ui, sans-serif";
  context.textAlign = align;
  context.textBaseline = 'middle';
  context.lineWidth = 3;
  context.strokeStyle = '#15131c';
  context.strokeText(text, x, y);
  context.fillStyle = '#d1c3aa';
  context.fillText(text, x, y);
}
