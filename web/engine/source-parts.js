// What all sources of scenes have in common: a name for messages, and the reasons why files that a
// scene names could not be read. Each source has
//
//     name               as it stands in messages
//     readText()         the scene's bytes; throws a Trouble
//     readFile(name)     the bytes of a file that the scene names, or null: `failures` then has the reason
//     pictures           perhaps: get(bytes) gives the pixels of a file that another engine has decoded,
//                        keep(bytes, pixels) hears of those that this one has
//
//     const source = { name: nameOf(address), readText, ...filesBy((file, onBytes) => fetchBytes(new URL(file, address), onBytes)) };
//     faults.map((fault) => withReason(fault, source.failures));

// Others (data:, blob:) have neither a name nor anything beside them.
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

// Whether a file that a scene of rows names lies beside the shipped scenes; the others are the
// author's own.
export function isShippedFile(file) {
  return /^\.\.\/(textures|see-through|sheets|sprites)\//.test(file);
}

// readFile gives null for a file that cannot be read, which is tried once: the engine says which
// place of the scene names it, `failures` why.
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

// The engine knows of a file only that it did not come.
export function withReason(fault, failures) {
  const reason = [...failures].find(([file]) => fault.found.startsWith(`"${file}", `))?.[1];
  if (reason === undefined) return fault;
  const found = `${fault.found}: ${reason}`;
  return { ...fault, found, message: fault.message.replace(fault.found, () => found) };
}
