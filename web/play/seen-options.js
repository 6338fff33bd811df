// Which of the engine's options belong to a view that is shared: those that change what is seen.
//
//     isOfView('fov')                     not those that move the player, nor those of the window
//     seenOptions(caster.optionList)      of these, without those whose overlay or light is off

const kNeverSeen = ['speed', 'bob', 'wideFov', 'overlayTop', 'overlayBottom'];

// The option that must be on.
const kSeenWith = {
  detailThreshold: 'detail',
  intensity: 'light',
  multiplier: 'light',
  minimapLevel: 'minimap',
  minimapRays: 'minimap',
  minimapTurns: 'minimap',
  minimapReach: 'minimap',
  inspectorColumn: 'inspector',
  slowSlices: 'slow',
};

export const isOfView = (name) => !kNeverSeen.includes(name);

export function seenOptions(options) {
  const values = new Map(options.map(({ name, value }) => [name, value]));
  const isClassic = values.get('method') === 'classic' || Number(values.get('compare')) > 0;
  return options.filter(({ name }) => {
    if (name.startsWith('classic.')) return isClassic;
    return isOfView(name) && values.get(kSeenWith[name] ?? '') !== 'off';
  });
}
