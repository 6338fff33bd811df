// What the plan shows over its level: the selection, and the cells that a stroke or a pasted part
// would change, those of other levels pale.
// Takes a canvas context, an editor and colours; paints. Changes nothing.
//
//     paintOverlay(context, editor, scale);     // true if it shows what is pointed at

import { cellOf } from './selection.js';
import { turned } from './tools/stamp.js';

const kPale = 0.35; // other levels
const kSolid = 0.7;
const kMostFilled = 20000; // cells; of more, the outline is shown
const kSelected = '#ecc862';
const kTouched = '#7fc4e8';

export function paintOverlay(context, editor, scale) {
  const { selection, tool, map, touched, level } = editor;
  if (tool.hasSelection && selection?.map === map)
    edges(context, editor.selectedOutline, scale, kSelected, level);
  if (touched === null || touched.size === 0) return false;
  const isPart = tool.hasStamps === true;
  const colours = isPart ? coloursOf(editor) : null;
  for (const key of touched.size > kMostFilled ? [] : touched) {
    const cell = cellOf(key);
    context.globalAlpha = (cell.level === level ? kSolid : kPale) * (isPart ? 1 : 0.5);
    context.fillStyle = colours?.get(key) ?? (isPart ? kSelected : kTouched);
    context.fillRect(cell.x * scale, cell.y * scale, scale, scale);
  }
  context.globalAlpha = 1;
  edges(context, editor.touchedEdges, scale, isPart ? kSelected : kTouched, level);
  return true;
}

// The colours of the part's cells; the set of them has the order of the part.
function coloursOf({ brush, touched }) {
  const { cells, colours = {} } = turned(brush);
  const keys = [...touched];
  return new Map(cells.map(({ sign }, index) => [keys[index], colours[sign]]));
}

// Seen from above: lines along the levels are points.
function edges(context, lines, scale, colour, level) {
  context.strokeStyle = colour;
  context.lineWidth = 2;
  for (const isHere of [false, true]) {
    context.globalAlpha = isHere ? 1 : 0.8;
    context.setLineDash(isHere ? [] : [4, 4]);
    context.beginPath();
    for (const { from, to } of lines) {
      if (from[2] !== to[2]) continue;
      if ((from[2] === level || from[2] === level + 1) !== isHere) continue;
      context.moveTo(from[0] * scale, from[1] * scale);
      context.lineTo(to[0] * scale, to[1] * scale);
    }
    context.stroke();
  }
  context.globalAlpha = 1;
  context.setLineDash([]);
}
