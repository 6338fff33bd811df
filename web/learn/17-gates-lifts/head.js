// A body creeps through the gate while it closes: the engine's gate waits, the formula does not.

import { box, drawing, fixed, line, slider, text } from '../figures/kit.js';
import { blockAt, gate, kStepsPerSecond, offsetAt } from './motion.js';

const kBody = { halfWidth: 0.2, height: 0.72 };
const kWest = 8.7; // what is drawn, in units
const kEast = 12.3;
const kTop = 1.25;

const engineEdge = (now) => blockAt(now, { x: 9, y: 4.5 }, 'gate')?.bottom ?? 1;
const formulaEdge = ({ state }) => offsetAt(gate, state.time / kStepsPerSecond);

// How far the lower edge is inside the body; 0 if it is not above it.
function depthIn(now, edge) {
  const { x } = now.eye;
  const isBelow = x + kBody.halfWidth > 10 && x - kBody.halfWidth < 11;
  return isBelow ? Math.max(0, kBody.height - edge) : 0;
}

function markup(edgeOf) {
  return (now, { width, height }) => {
    const unit = Math.min(width / (kEast - kWest), (height - 8) / kTop);
    const left = (width - (kEast - kWest) * unit) / 2;
    const at = (x, z) => [left + (x - kWest) * unit, height - 6 - z * unit];
    const edge = edgeOf(now);
    const inside = depthIn(now, edge);
    const rect = (west, east, low, high, attributes) => {
      const [x, y] = at(west, high);
      return box(x, y, (east - west) * unit, (high - low) * unit, attributes);
    };
    const { x } = now.eye;
    const [bodyX, bodyY] = at(x, 0.1);
    const parts = [
      rect(kWest, kEast, 1, kTop, 'class="fig-solid seen"'),
      rect(x - kBody.halfWidth, x + kBody.halfWidth, 0, kBody.height, 'class="fig-lit"'),
      rect(10, 11, Math.min(edge, 1), 1, 'fill="var(--stone)"'),
    ];
    if (inside > 0)
      parts.push(
        rect(
          Math.max(10, x - kBody.halfWidth),
          Math.min(11, x + kBody.halfWidth),
          edge,
          kBody.height,
          'fill="var(--ray)"',
        ),
      );
    const [lineX, lineY] = at(10, edge);
    parts.push(
      line(...at(kWest, 0), ...at(kEast, 0), 'class="fig-axis"'),
      line(lineX - 8, lineY, lineX + unit + 8, lineY, 'class="fig-ray"'),
      text(...at(kEast - 0.1, edge + 0.04), `${fixed(edge)} up`, 'text-anchor="end"'),
      text(bodyX, bodyY, 'body', 'class="on-lit" text-anchor="middle"'),
      text(lineX - 14, lineY + 5, 'gate', 'text-anchor="end"'),
    );
    return parts.join('');
  };
}

const view = (title, edgeOf) =>
  drawing({
    title,
    height: (width) => Math.min(230, width * 0.4),
    label: (now) => `${title}: its lower edge is ${fixed(edgeOf(now))} units up`,
    markup: markup(edgeOf),
  });

export default {
  scene: 'yard-6.json',
  view: '9.7,4.5,0.5,0,0',
  size: [480, 300],
  state: { time: 760 },
  input: { forward: 0.1 },
  controls: [
    slider({
      label: 'Time',
      field: 'time',
      from: 0,
      to: 1080,
      step: 4,
      says: (value) => `${fixed(value / kStepsPerSecond)} s`,
    }),
  ],
  rows: [
    [
      view('The gate that waits (the engine)', engineEdge),
      view('The gate that follows the formula', formulaEdge),
    ],
  ],
  numbers: { into: (now) => depthIn(now, formulaEdge(now)) },
  says: (now) => {
    const into = depthIn(now, formulaEdge(now));
    const late = engineEdge(now) - formulaEdge(now);
    if (into > 0)
      return `The formula alone has the edge ${fixed(into)} units inside the head. The engine's gate stopped above it.`;
    if (late > 0.02)
      return 'The body has left. The gate that waited closes later than the other one.';
    return 'The two gates are in the same place.';
  },
};
