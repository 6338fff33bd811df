// The formula of the chapter, as the engine computes it (src/world/motion.h).

const smooth = (p) => p * p * (3 - 2 * p);

export const shapes = {
  even: (p) => p,
  smooth,
  'stop-and-go': (p) => smooth(Math.min(1, Math.max(0, 2 * p - 0.5))),
};

// From 0 to 1 and back within a period.
export const partAt = (seconds, period) => {
  const at = seconds % period;
  return (2 * Math.min(at, period - at)) / period;
};

export const offsetAt = ({ period, shape, from = 0, to }, seconds) =>
  from + (to - from) * shapes[shape](partAt(seconds, period));

// The gate of the yard, and a moment in the engine's steps.
export const gate = { period: 8, shape: 'stop-and-go', to: 0.9 };
export const kStepsPerSecond = 120;

// The block of a kind that a ray along y meets first, as the engine has it at this moment.
export function blockAt(now, from, blueprint) {
  const { hits } = now.source.cast({ map: 'yard', heading: 0, ...from });
  return hits.find((hit) => hit.blueprint === blueprint) ?? null;
}
