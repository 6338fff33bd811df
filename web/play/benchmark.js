// Measures how fast this machine draws: a fixed flight through the scene at a fixed size, each
// picture drawn once, with a graph of the times and a table to copy. Nothing else runs meanwhile.
// The limit is measured between the pictures, as in tools/bench.
//
//     const figures = await measure(caster, { views, width, height, onProgress, isWanted });
//     figures: {times, median, slow, slowest, nanosecondsPerPixel, timesTheLimit, size, pictures,
//     inPlay}, times in milliseconds; timesTheLimit is null if the limit cannot be measured
//     drawGraph(canvas, figures.times);
//     asText(figures, title)

import { loadLimit } from './limit.js';
import { sizeText } from './size-now.js';

const kWarmUp = 12; // pictures drawn first and not counted
const kLimitEvery = 8; // the limit is measured once every so many pictures
const kPlayed = 3000; // milliseconds of play
const kMayEnd = 200; // milliseconds, after which it may end
const kBatch = 16; // milliseconds of drawing before the page may react

// Returns null if `isWanted()` becomes false meanwhile.
export async function measure(caster, { views, width, height, onProgress, isWanted }) {
  const before = caster.currentView;
  let inPlay = null;
  const limit = await loadLimit(width, height);
  const times = [];
  const limitTimes = [];
  let breath = performance.now();
  try {
    for (let i = -kWarmUp; i < views.length; ++i) {
      caster.look(views[Math.max(0, i)]);
      const time = caster.timeDrawing({ width, height });
      if (i >= 0) times.push(time);
      if (limit !== null && i % kLimitEvery === 0) {
        const limitTime = limit.time();
        if (i >= 0) limitTimes.push(limitTime);
      }
      if (performance.now() - breath < kBatch) continue;
      onProgress(times);
      await new Promise((resolve) => setTimeout(resolve));
      if (!isWanted()) return null;
      breath = performance.now();
    }
    inPlay = await playFlight(caster, views, isWanted);
    if (!isWanted()) return null;
  } finally {
    if (caster.world !== null) caster.look(before);
  }
  const median = quantile(times, 0.5);
  return {
    times,
    median,
    slow: quantile(times, 0.95),
    slowest: Math.max(...times),
    nanosecondsPerPixel: (median * 1e6) / (width * height),
    timesTheLimit: limit === null ? null : median / quantile(limitTimes, 0.5),
    size: `${width} × ${height}`,
    pictures: times.length,
    inPlay,
  };
}

// What somebody sees who plays: the pictures a second and their size, when the page has found how
// many pixels it can draw.
async function playFlight(caster, views, isWanted) {
  let pace = null;
  let next = 0;
  const note = ({ detail }) => (pace = detail);
  const fly = () => caster.look(views[next++ % views.length]);
  caster.addEventListener('pace', note);
  caster.addEventListener('framechange', fly);
  caster.play();
  for (let played = 0; played < kPlayed && isWanted(); played += kMayEnd)
    await new Promise((resolve) => setTimeout(resolve, kMayEnd));
  caster.removeEventListener('framechange', fly);
  caster.removeEventListener('pace', note);
  caster.pause();
  return pace === null
    ? 'not measured'
    : `${Math.round(pace.framesPerSecond)} a second, ${sizeText(caster, pace)}`;
}

function quantile(values, share) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
}

export function rowsOf({
  median,
  slow,
  slowest,
  nanosecondsPerPixel,
  timesTheLimit,
  size,
  pictures,
  inPlay,
}) {
  const ms = (time) => `${time.toFixed(2)} ms`;
  return [
    ['Picture', size],
    ['Pictures drawn', String(pictures)],
    ['Median', `${ms(median)}, ${Math.round(1000 / median)} a second`],
    ['19 of 20 within', ms(slow)],
    ['Slowest', ms(slowest)],
    ['Per pixel', `${nanosecondsPerPixel.toFixed(2)} ns`],
    [
      'Times the limit',
      timesTheLimit === null ? 'not measured: it needs WebAssembly SIMD' : timesTheLimit.toFixed(2),
    ],
    ['In play', inPlay],
  ];
}

// Text to paste: one figure per line.
export function asText(figures, title) {
  const rows = [['Scene', title], ...rowsOf(figures), ['Browser', navigator.userAgent]];
  return rows.map(([name, value]) => `${name}\t${value}`).join('\n');
}

// Draws one bar per picture, as high as its time. The dashed line marks 1/60 s, or 1/120 s if all
// are quicker. Outliers are cut off at the top.
export function drawGraph(canvas, times, count) {
  const ratio = window.devicePixelRatio || 1;
  const width = Math.round(canvas.clientWidth * ratio);
  const height = Math.round(canvas.clientHeight * ratio);
  if (width === 0 || height === 0) return;
  Object.assign(canvas, { width, height });
  const paint = canvas.getContext('2d');
  const sorted = [...times].sort((a, b) => a - b);
  const highest = Math.max(8, 1.5 * (sorted[Math.floor(0.95 * sorted.length)] ?? 0));
  const style = getComputedStyle(canvas);
  paint.fillStyle = style.getPropertyValue('--brass');
  const step = width / count;
  times.forEach((time, index) => {
    const bar = Math.max(1, (time / highest) * height);
    paint.fillRect(index * step, height - bar, Math.max(1, step - (step > 3 ? 1 : 0)), bar);
  });
  const mark = highest > 1000 / 60 ? 1000 / 60 : 1000 / 120;
  const y = Math.round(height - (mark / highest) * height) + 0.5;
  paint.strokeStyle = style.getPropertyValue('--text-faint');
  paint.setLineDash([4 * ratio, 4 * ratio]);
  paint.beginPath();
  paint.moveTo(0, y);
  paint.lineTo(width, y);
  paint.stroke();
  paint.fillStyle = style.getPropertyValue('--text-soft');
  paint.font = `${12 * ratio}px sans-serif`;
  paint.fillText(`${mark.toFixed(1)} ms`, 4 * ratio, y - 4 * ratio);
}
