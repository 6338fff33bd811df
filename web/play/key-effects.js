// Shows a line of text when a key has an effect that is hard to see: changed light, fly mode, no
// gate within reach.
//
//     listenForEffects(caster, toast);

import { codesOf, labelOf } from './key-list.js';

const kSettle = 80; // milliseconds; by then the world has taken the step in which the key acts

const times = (text) => `${Number(text).toFixed(1)} ×`;
const units = (text) => Number(text).toFixed(1);
const kTimesOfDay = { map: "the scene's own" };

// Options that keys change with little visible effect, and the text to show.
const kEffects = [
  { option: 'lightPreset', says: (value) => `Time of day: ${kTimesOfDay[value] ?? value}` },
  { option: 'intensity', says: (value) => `Light: intensity ${units(value)}` },
  { option: 'multiplier', says: (value) => `Light: reach ${units(value)}` },
  { option: 'mirrors', says: (value) => `Mirrors: ${times(value)}` },
  { option: 'minimapTurns', says: (value) => `Minimap: ${value === 'on' ? 'turns' : 'north up'}` },
  {
    option: 'minimapLevel',
    says: (value) => `Minimap: ${value === '-1' ? 'your level' : `level ${value}`}`,
  },
  { option: 'slowSlices', says: slowText },
];

const kGateActions = ['use', 'open', 'close'];

export function listenForEffects(caster, toast) {
  const values = () => kEffects.map(({ option }) => caster.get(option));
  // In the capture phase: before the engine acts on the key.
  const listen = ({ code, repeat, ctrlKey, metaKey, altKey }) => {
    if (!caster.entered || ctrlKey || metaKey || altKey) return;
    const before = values();
    const hasGate = caster.player.gate !== '';
    setTimeout(() => {
      if (caster.world === null) return;
      const changed = values().findIndex((value, index) => value !== before[index]);
      if (changed >= 0) toast.show(kEffects[changed].says(values()[changed]));
      else if (!repeat && !hasGate && codesOf(caster, kGateActions).includes(code))
        toast.show('No gate within reach');
    }, kSettle);
  };
  caster.addEventListener('keydown', listen, { capture: true });
  caster.addEventListener('modechange', ({ detail: { mode, on } }) => {
    if (mode === 'sound' && caster.entered) toast.show(on ? 'Sound on' : 'Sound off');
    if (mode === 'fly' && caster.entered)
      toast.show(
        on
          ? `Flying: ${labelOf(caster, 'jump')} rises, ${labelOf(caster, 'sink')} sinks`
          : 'Walking',
      );
  });
}

function slowText(value) {
  const count = Number(value);
  return count > 0
    ? `${count} more columns with each picture`
    : `One more column every ${-count} pictures`;
}
