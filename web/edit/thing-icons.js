// Small pictures of the kinds of things that are no pictures themselves: for the palette and the
// plan. Takes a canvas' context; paints. Knows no document.
//
//     paintThing(context, 'lamp', size)         // in a square of that size, from 0, 0 on

import { kLinkLooks } from './link-looks.js';

// In a square of 16.
const kIcons = {
  start: ['#e3835f', 'M5 1h2v14H5zM7 2h7l-2 3 2 3H7z'],
  lamp: ['#ffd98a', 'M6 2h4v1h2v2h1v4h-1v2h-2v2H6v-2H4V9H3V5h1V3h2zM6 14h4v1H6z'],
  message: [kLinkLooks.message.colour, 'M2 3h12v8H8l-4 3v-3H2zM4 5v1h8V5zM4 8v1h6V8z'],
  goal: [kLinkLooks.goal.colour, 'M3 2h7v2H5v8h5v2H3zM8 7h4V5l3 3-3 3V9H8z'],
  place: ['#f7f1e1', 'M5 1h6v2h2v5h-2v2H9v5H7v-5H5V8H3V3h2zM7 4v3h2V4z'],
};

export const thingColour = (kind) => kIcons[kind]?.[0] ?? '#8fce7a';

export function paintThing(context, kind, size) {
  const [colour, path] = kIcons[kind];
  context.save();
  context.scale(size / 16, size / 16);
  const shape = new Path2D(path);
  context.lineWidth = 2;
  context.strokeStyle = '#15131c';
  context.lineJoin = 'round';
  context.stroke(shape);
  context.fillStyle = colour;
  context.fill(shape, 'evenodd');
  context.restore();
}
