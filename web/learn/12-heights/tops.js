import {
  box,
  clamp,
  dot,
  drawing,
  fixed,
  knob,
  line,
  picture,
  slider,
  sliceStrip,
  text,
} from '../figures/kit.js';
import { kPillars, laneEdits, laneScene } from './lane.js';

const kOpening = [3, 4, 9]; // quarters of a unit
const kFarthest = 10.6; // depth at the right edge
const kHighest = 3.15;
const kLeft = 30;
const kFoot = 26;
const kTall = 300;

// The pillars with their slopes, and whether each rises above all before it.
export function pillarsOf(now) {
  return now.kept('pillars', () => {
    const { eye, heights } = { eye: now.eye, heights: now.state.heights };
    let steepest = -eye.z / (kPillars[0].x - eye.x); // of what the floor before the first one shows
    let by = null;
    return kPillars.map(({ x, name }, index) => {
      const depth = x - eye.x;
      const top = heights[index] / 4;
      const slope = (top - eye.z) / depth;
      const hiddenTo = by === null ? 0 : Math.max(0, eye.z + steepest * depth);
      const isSeen = top > 0 && top > hiddenTo;
      const pillar = { name, depth, top, slope, hiddenTo, isSeen };
      if (top > 0 && slope > steepest) [steepest, by] = [slope, index];
      return pillar;
    });
  });
}

function frame({ width }) {
  const unitX = (width - kLeft - 8) / kFarthest;
  const unitZ = (kTall - kFoot - 10) / kHighest;
  return {
    place: (depth, z) => [kLeft + unitX * depth, kTall - kFoot - unitZ * z],
    heightAt: (y) => (kTall - kFoot - y) / unitZ,
    unitX,
    unitZ,
  };
}

function side(now, size) {
  const { place, unitX } = frame(size);
  const [, ground] = place(0, 0);
  const parts = [box(kLeft, ground, size.width - kLeft, kFoot, 'class="fig-earth"')];
  const pillars = pillarsOf(now);
  for (const { depth, top, hiddenTo, isSeen } of pillars) {
    const [x, y] = place(depth, top);
    parts.push(box(x, y, unitX, ground - y, `class="fig-solid${isSeen ? ' seen' : ''}"`));
    if (!isSeen) continue;
    const [, low] = place(depth, hiddenTo);
    parts.push(line(x, y, x, low, 'stroke="var(--along)" stroke-width="5"'));
  }
  let steepest = -Infinity;
  for (const { slope, top, depth } of pillars) {
    if (top === 0 || slope <= steepest) continue;
    steepest = slope;
    const end = Math.min(kFarthest, slope > 0 ? (kHighest - now.eye.z) / slope : kFarthest);
    parts.push(
      line(...place(0, now.eye.z), ...place(depth, top), 'stroke="var(--ray)" stroke-width="2"'),
      line(
        ...place(depth, top),
        ...place(end, now.eye.z + slope * end),
        'stroke="var(--ray)" stroke-width="2" stroke-dasharray="5 4"',
      ),
    );
  }
  for (let z = 0; z <= 3; ++z)
    parts.push(text(kLeft - 8, place(0, z)[1] + 4, String(z), 'class="soft" text-anchor="end"'));
  for (let depth = 1; depth < kFarthest; ++depth)
    parts.push(
      text(place(depth, 0)[0], kTall - 7, String(depth), 'class="soft" text-anchor="middle"'),
    );
  parts.push(dot(...place(0, now.eye.z), 8, 'class="fig-eye"'));
  for (const { depth, top } of pillars) {
    const [x, y] = place(depth + 0.5, top);
    parts.push(knob(x, y, 'ray'), text(x, y - 18, fixed(top), 'class="halo" text-anchor="middle"'));
  }
  return parts.join('');
}

function handles(now, size) {
  const { place, heightAt } = frame(size);
  return pillarsOf(now).map(({ name, depth, top }, index) => {
    const [x, y] = place(depth + 0.5, top);
    const put = (quarters) => ({
      heights: now.state.heights.map((height, other) =>
        other === index ? clamp(Math.round(quarters), 0, 12) : height,
      ),
    });
    return {
      id: name,
      label: `Top of the ${name} pillar`,
      axis: 'y',
      x,
      y,
      value: top,
      least: 0,
      greatest: 3,
      says: `${fixed(top)} units`,
      drag: (point) => put(4 * heightAt(point.y)),
      keys: (right, down) => put(4 * top - (down || -right)),
    };
  });
}

const listed = (names) =>
  names.length < 2 ? names.join('') : `${names.slice(0, -1).join(', ')} and ${names.at(-1)}`;

export default {
  scene: laneScene,
  view: '0.5,1.5,0.5,0',
  options: { fov: 66 },
  state: { heights: kOpening, edits: laneEdits(kOpening), column: 240 },
  check: ({ heights }) => ({ edits: laneEdits(heights) }),
  controls: [slider({ label: 'Eye', eye: 'z', from: 0.25, to: 1.5, step: 0.05, unit: 'units' })],
  rows: [
    [
      drawing({
        title: 'Drag the tops',
        height: kTall,
        label: (now) =>
          pillarsOf(now)
            .map(
              ({ name, top, isSeen }) =>
                `${name} pillar: ${fixed(top)} high, ${isSeen ? 'seen' : 'hidden'}`,
            )
            .join('; '),
        markup: side,
        handles,
      }),
    ],
    [
      picture({ title: 'What the eye sees', handles: [] }),
      sliceStrip({ title: 'The rows of the slice', pick: false }),
    ],
  ],
  numbers: { top: (now) => fixed(pillarsOf(now)[2].hiddenTo) },
  says: (now) => {
    const pillars = pillarsOf(now);
    const hidden = pillars.filter(({ isSeen, top }) => !isSeen && top > 0).map(({ name }) => name);
    const slopes = pillars.map(({ slope }) => fixed(slope)).join(', ');
    const all = `The slopes of the tops are ${slopes}.`;
    if (hidden.length === 0) return `${all} Every pillar shows something.`;
    return `${all} Hidden: the ${listed(hidden)} pillar${hidden.length > 1 ? 's' : ''}.`;
  },
};
