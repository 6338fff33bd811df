// The common parts of scene sources. A source is an object with
//
//     name               for messages
//     readText()         the scene's bytes; throws a Trouble
//     addressOf(name)    optional: where that file is, a URL
//     readFile(name)     the bytes of a file that the scene names, or null; `failures` then has why
//     pictures           optional: get(bytes) returns the pixels of a file that another engine has
//                        decoded, keep(bytes, pixels) is told of those that this one has decoded
//
//     const read = (file, onBytes) =>
//       readFirst(placesOf(file, new URL(file, address), home), (at) => fetchBytes(at, onBytes));
//     const source = { name: nameOf(address), readText, ...filesBy(read) };
//     faults.map((fault) => withReason(fault, source.failures));

// Other addresses (data:, blob:) have no file name, and no files beside them.
export function isFile(address) {
  return /^(https?|file):$/.test(address.protocol);
}

export function nameOf(address) {
  if (!isFile(address)) return `${address.protocol} address`;
  const name = address.pathname.split('/').pop();
  try {
    return decodeURIComponent(name);
  } catch {
    return name;
  }
}

// The files that a scene's text names, where the engine looks for them, as far as their names are
// plain: whatever folder they are relative to, they lie on its host. Throws if it is not a scene.
export function picturesIn(bytes) {
  const { textures = {}, sprites = {}, maps } = JSON.parse(new TextDecoder().decode(bytes));
  const skies = maps.map(({ sky }) => sky?.panorama);
  const named = [...Object.values(textures), ...Object.values(sprites), ...skies];
  const files = named.map((picture) => picture?.file ?? picture);
  return [...new Set(files)].filter((file) => /^(?!.*\/\/)[\w.][\w./-]*\.(png|PNG)$/.test(file));
}

// Whether a name may be that of a shipped file, as shipped scenes name them.
export function isShippedFile(file) {
  return /^\.\.\/(textures|see-through|sheets|sprites)\/[\w-]+\.png$/.test(file);
}

// The table of the shipped pictures (src/scene/scene.h), and how names of shipped files begin,
// wherever the scene is: they are in the package's own folder.
export const kShippedTable = 'slicecast:pictures.json';

// The address of such a file, or undefined.
export function shippedAddress(file, home) {
  const [, path] = /^slicecast:(.*)/.exec(file) ?? [];
  return path && new URL(path, home);
}

// Where a file that a scene names may be, in turn: beside the scene, unless that is null; then, if
// it may be a shipped one, in the package's folder.
export function placesOf(file, beside, home) {
  const named = shippedAddress(file, home);
  if (named) return [named];
  const places = [beside, isShippedFile(file) ? new URL(`scenes/${file}`, home) : null];
  return places.filter((place, at) => place !== null && place.href !== places[at - 1]?.href);
}

// The first of them that can be read; else the reason is that of the first.
export function readFirst([place, ...others], read) {
  return others.length === 0
    ? read(place)
    : read(place).catch((error) =>
        readFirst(others, read).catch(() => {
          throw error;
        }),
      );
}

// readFile returns null for a file that cannot be read, and does not try it again. The engine
// reports the place in the scene that names it; `failures` has the reason.
export function filesBy(read) {
  const failures = new Map();
  return {
    failures,
    async readFile(file, onBytes) {
      if (failures.has(file)) return null;
      try {
        return await read(file, onBytes);
      } catch (error) {
        failures.set(file, error.message);
        return null;
      }
    },
  };
}

// Adds the reason to the engine's fault, which says only that the file could not be read.
export function withReason(fault, failures) {
  const reason = [...failures].find(([file]) => fault.found.startsWith(`"${file}", `))?.[1];
  if (reason === undefined) return fault;
  const found = `${fault.found}: ${reason}`;
  return { ...fault, found, message: fault.message.replace(fault.found, () => found) };
}
