// The best time of each scene's game, kept in this browser. Where nothing can be stored, as in some
// private windows, it lasts as long as the page.
//
//     keepTime('wayhouse-hunt.json', 15360)     true if it is the best so far
//     bestTime('wayhouse-hunt.json')            128 seconds, or null
//
// Times are kept in steps of the engine, which are whole numbers.

const kStorageKey = 'slicecast.best-times';
const kStepsPerSecond = 120;
const kMost = 100; // scenes

let kept = null;

export function bestTime(scene) {
  const steps = read()[scene];
  return steps === undefined ? null : steps / kStepsPerSecond;
}

export function keepTime(scene, steps) {
  const times = read();
  if (scene === null || !isTime(steps) || times[scene] <= steps) return false;
  // The newest come last, and the oldest are forgotten.
  const others = Object.entries(times).filter(([other]) => other !== scene);
  kept = Object.fromEntries([...others, [scene, steps]].slice(-kMost));
  try {
    localStorage.setItem(kStorageKey, JSON.stringify(kept));
  } catch {
    // Kept in memory only
  }
  return true;
}

const isTime = (steps) => Number.isInteger(steps) && steps > 0;

function read() {
  if (kept !== null) return kept;
  let stored = null;
  try {
    stored = JSON.parse(localStorage.getItem(kStorageKey));
  } catch {
    // Nothing can be read, or somebody wrote something else
  }
  const entries = typeof stored === 'object' && stored !== null ? Object.entries(stored) : [];
  kept = Object.fromEntries(entries.filter(([, steps]) => isTime(steps)));
  return kept;
}
