// The sky of one column: a colour for the slope of each row.

import { clamp, drawing, fixed, hex, line, picture, polygon, text } from '../figures/kit.js';

const kLow = [0xf1, 0xe2, 0xc4];
const kHigh = [0x5f, 0x9f, 0xd4];
const kSteepest = 1.25; // at the upper end of the drawing
const kLeft = 52;
const kStrip = 90;

const slopeIn = ({ slice }, row) => (slice.horizonRow - (row + 0.5)) / slice.projectionDistance;
const shareOf = (slope) => clamp(slope, 0, 1);
const colourAt = (slope) =>
  kLow.map((low, channel) => Math.floor(low + (kHigh[channel] - low) * shareOf(slope) + 0.5));

const strip = drawing({
  title: 'The sky by slope',
  label: (now) =>
    `Colours of the sky from slope 0 to slope 1. Row ${now.row} has the slope ${fixed(slopeIn(now, now.row))}.`,
  height: () => 310,
  markup(now, { width, height }) {
    const foot = height - 24;
    const y = (slope) => foot - ((foot - 12) * slope) / kSteepest;
    const parts = [];
    for (let slope = 0; slope < kSteepest - 1e-6; slope += 0.0125)
      parts.push(
        now.box(
          kLeft,
          y(slope + 0.0125),
          kStrip,
          y(slope) - y(slope + 0.0125) + 0.6,
          `fill="${hex(colourAt(slope))}"`,
        ),
      );
    for (const slope of [0, 0.25, 0.5, 0.75, 1, 1.25])
      parts.push(
        line(kLeft - 7, y(slope), kLeft, y(slope), 'class="fig-measure"'),
        text(kLeft - 11, y(slope) + 4.5, fixed(slope), 'class="soft" text-anchor="end"'),
      );
    // The rows of the picture that look up, beside the slopes that they show.
    const top = clamp(slopeIn(now, -0.5), 0, kSteepest);
    const end = clamp(slopeIn(now, now.height - 0.5), 0, kSteepest);
    const x = kLeft + kStrip + 14;
    if (top > end) {
      parts.push(now.box(x, y(top), 7, y(end) - y(top), 'class="fig-plane"'));
      const lines = width - x - 26 < 130 ? ['the', 'picture'] : ['in the picture'];
      const middle = (y(top) + y(end)) / 2;
      lines.forEach((words, index) =>
        parts.push(text(x + 16, middle + 34 + 17 * index, words, 'class="soft"')),
      );
    }
    const slope = slopeIn(now, now.row);
    if (slope >= 0 && slope <= kSteepest) {
      const from = y(slope);
      parts.push(
        line(kLeft, from, x + 7, from, 'class="fig-bold"'),
        polygon(
          [
            [x + 8, from],
            [x + 16, from - 5],
            [x + 16, from + 5],
          ],
          'class="fig-badge"',
        ),
        text(x + 21, from + 4.5, `row ${now.row}, slope ${fixed(slope)}`),
        now.box(x + 21, from + 12, 30, 15, `class="fig-outline" fill="${hex(colourAt(slope))}"`),
      );
    }
    return parts.join('');
  },
});

const channel = (of) => (now) => String(of(now));

export default {
  scene: 'yard-2.json',
  view: '9.4,4.5,0.5,192,0.25',
  options: { fov: 66 },
  size: [480, 300],
  state: { row: 60, column: 240 },
  rows: [[picture({ handles: ['row', 'look'], mark: 'row', share: 1.5 }), strip]],
  numbers: {
    row: channel(({ row }) => row),
    slope: (now) => fixed(slopeIn(now, now.row), 3),
    share: (now) => fixed(shareOf(slopeIn(now, now.row)), 3),
    low: () => String(kLow[0]),
    high: () => String(kHigh[0]),
    distance: (now) => fixed(now.slice.projectionDistance, 1),
    red: (now) => String(colourAt(slopeIn(now, now.row))[0]),
  },
  says(now) {
    const slope = slopeIn(now, now.row);
    if (slope < 0)
      return `Row ${now.row} looks down: slope ${fixed(slope)}. Where nothing is met there, the map has its haze.`;
    const engine =
      now.pick?.what === 'sky'
        ? ' In the middle column the picture shows it.'
        : ' In the middle column something hides it.';
    return `Row ${now.row} has the slope ${fixed(slope)}: ${hex(colourAt(slope))}.${engine}`;
  },
};
