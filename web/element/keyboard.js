// The keys for a visitor to read: in groups, and named as on the visitor's own keyboard where the
// browser tells. The engine names them as on an American one.
//
//     ownKeys(keys)         the engine's list of keys with the labels of this keyboard
//     keyGroups(keys)       [['Moving', [line, ...]], ...]: the lines that have keys

export const kGroups = {
  move: 'Moving',
  look: 'Looking',
  gates: 'Gates',
  light: 'Light',
  show: 'To see how it works',
  program: 'The picture',
};

let layout = null; // KeyboardLayoutMap; only some browsers have one, and only some frames may ask
navigator.keyboard?.getLayoutMap?.().then(
  (map) => {
    layout = map;
  },
  () => {},
);

function ownLabel({ code, label }) {
  const here = layout.get(code)?.toUpperCase();
  return here?.trim().length === 1 ? here : label;
}

export function ownKeys(lines) {
  if (layout === null) return lines;
  return lines.map((line) => {
    const here = new Map(); // American label -> label
    const own = (key) => {
      here.set(key.label, ownLabel(key));
      return { ...key, label: here.get(key.label) };
    };
    const actions = line.actions.map((action) => ({ ...action, keys: action.keys.map(own) }));
    return { ...line, actions, keys: line.keys.map((label) => here.get(label) ?? label) };
  });
}

export function keyGroups(lines) {
  return Object.entries(kGroups)
    .map(([group, title]) => [
      title,
      lines.filter((line) => line.group === group && line.keys.length > 0),
    ])
    .filter(([, own]) => own.length > 0);
}
