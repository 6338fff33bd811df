import { box, drawing, fixed, line, slider, text } from '../figures/kit.js';

const kSpeed = 3; // units a second
const kSeconds = 2;
const kUsual = 60; // frames a second
const kLength = kSpeed / kUsual; // units for each frame, made for the usual machine
const kFarthest = 12; // units, of the tracks

const framesIn = (fps) => Math.floor(kSeconds * fps + 1e-9);
const byFrame = (fps) => framesIn(fps) * kLength;
const bySecond = (fps) => framesIn(fps) * (kSpeed / fps);

const kTracks = [
  { name: 'a fixed length for each frame', of: byFrame },
  { name: 'a fixed length for each second', of: bySecond },
];

// In a narrow window, words stand above the bars.
const isNarrow = (width) => width < 480;
const spacingOf = (width) => (isNarrow(width) ? { lanes: 56, all: 168 } : { lanes: 44, all: 128 });

function tracks(now, { width }) {
  const { fps } = now.state;
  const left = 8;
  const unit = (width - left - 16) / kFarthest;
  const { lanes, all } = spacingOf(width);
  const parts = [];
  kTracks.forEach(({ name, of }, index) => {
    const top = 22 + all * index;
    parts.push(text(left, top - (isNarrow(width) ? 8 : 4), name, 'class="strong"'));
    [kUsual, fps].forEach((rate, lane) => {
      const y = top + lanes - 34 + lanes * lane;
      const way = Math.min(kFarthest, of(rate));
      parts.push(
        box(left, y, unit * kFarthest, 30, 'fill="var(--sheet)" stroke="var(--rule)"'),
        box(
          left,
          y,
          unit * way,
          30,
          `fill="var(--${lane === 0 ? 'soft' : 'ray'})" fill-opacity="0.3"`,
        ),
      );
      // Every tenth frame
      for (let frame = 10; frame <= framesIn(rate); frame += 10) {
        const x = left + unit * Math.min(kFarthest, (of(rate) * frame) / framesIn(rate));
        parts.push(line(x, y + 22, x, y + 30, 'stroke="var(--ink)" stroke-opacity="0.5"'));
      }
      parts.push(
        line(
          left + unit * way,
          y,
          left + unit * way,
          y + 30,
          'stroke="var(--ink)" stroke-width="3"',
        ),
        text(
          ...(isNarrow(width)
            ? [left, y - 6]
            : width - left - unit * way > 230
              ? [left + unit * way + 8, y + 19]
              : [left + 6, y + 19]),
          `${rate} frames a second: ${fixed(of(rate))} units`,
          'class="halo"',
        ),
      );
    });
  });
  return parts.join('');
}

export default {
  scene: 'yard-2.json',
  view: '7.5,1.5,0.5,180',
  state: { fps: 25 },
  controls: [
    slider({
      label: 'Lower machine',
      field: 'fps',
      from: 10,
      to: 120,
      step: 1,
      unit: 'frames a second',
    }),
  ],
  rows: [
    [
      drawing({
        title: 'Two seconds of walking',
        height: (width) => 6 + 2 * spacingOf(width).all,
        label: (now) =>
          `After two seconds: ${kTracks.map(({ name, of }) => `${name}: ${fixed(of(kUsual))} and ${fixed(of(now.state.fps))} units`).join('; ')}`,
        markup: tracks,
      }),
    ],
  ],
  numbers: { perFrame: () => fixed(kLength) },
  says: ({ state: { fps } }) =>
    fps === kUsual
      ? 'Both machines are equally fast, and nothing shows.'
      : `A mark stands for ten frames. Above, the ${fps < kUsual ? 'slower' : 'faster'} machine walks ${fixed(Math.abs(byFrame(fps) - byFrame(kUsual)))} units ${fps < kUsual ? 'less' : 'more'}; below, the two differ by at most one frame.`,
};
