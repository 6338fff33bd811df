// The shipped pictures that a scene names without declaring them (assets/pictures.json).
// Takes values of scenes; gives entries as a scene would have them.
//
//     knowShipped(JSON.parse(text of pictures.json));
//     shippedPicture('textures', 'lava')        // {file: '../sheets/lava.png', frames: 8, rate: 6}
//     pictureOf(value, 'textures', 'lava')      // what the scene says of it, or the table
//     namesToChoose(value, 'sprites')           // those of the scene first
//     declared(value, isUsed)                   // the scene, which declares those that it uses too

const kShipped = { textures: {}, sprites: {} };

export function knowShipped(table) {
  const moved = (entry) =>
    typeof entry === 'string' ? `../${entry}` : { ...entry, file: `../${entry.file}` };
  for (const what of Object.keys(kShipped))
    kShipped[what] = Object.fromEntries(
      Object.entries(table[what]).map(([name, entry]) => [name, moved(entry)]),
    );
}

const own = (table, name) => (Object.hasOwn(table ?? {}, name) ? table[name] : undefined);

export const shippedPicture = (what, name) => own(kShipped[what], name);

export function pictureOf(value, what, name) {
  return own(value[what], name) ?? shippedPicture(what, name);
}

export function namesToChoose(value, what) {
  return [...new Set([...Object.keys(value[what] ?? {}), ...Object.keys(kShipped[what])])];
}

export function declared(value, isUsed) {
  const next = { ...value };
  for (const [what, table] of Object.entries(kShipped)) {
    const used = Object.entries(table).filter(
      ([name]) => isUsed(name) && !Object.hasOwn(value[what] ?? {}, name),
    );
    if (used.length > 0) next[what] = { ...value[what], ...Object.fromEntries(used) };
  }
  return next;
}
