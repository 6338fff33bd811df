// The pictures of a part that no world has by itself: they go along as bytes.
// Takes parts (parts.js) and a world's own pictures, file -> bytes; gives parts.
//
//     const part = withPictures(partOf(...), own);     // with `pictures`: {file: bytes}
//     const taken = takePictures(part, own);           // into `own`; files of others are renamed

const filesOf = (entry) => (typeof entry === 'string' ? entry : entry.file);

export function withPictures(part, own) {
  const files = [...Object.values(part.textures), ...Object.values(part.sprites)].map(filesOf);
  const pictures = Object.fromEntries(
    files.filter((file) => own.has(file)).map((file) => [file, own.get(file)]),
  );
  return { ...part, pictures };
}

export function takePictures(part, own) {
  const renamed = new Map();
  for (const [file, bytes] of Object.entries(part.pictures ?? {})) {
    const name = freeFile(file, bytes, own);
    renamed.set(file, name);
    own.set(name, bytes);
  }
  const named = (entries) =>
    Object.fromEntries(
      Object.entries(entries).map(([name, entry]) => {
        const file = renamed.get(filesOf(entry)) ?? filesOf(entry);
        return [name, typeof entry === 'string' ? file : { ...entry, file }];
      }),
    );
  return { ...part, textures: named(part.textures), sprites: named(part.sprites) };
}

function freeFile(file, bytes, own) {
  for (let count = 1; ; ++count) {
    const name = count === 1 ? file : file.replace(/(\.\w+)?$/, `-${count}$1`);
    if (!own.has(name) || isSameBytes(own.get(name), bytes)) return name;
  }
}

function isSameBytes(one, other) {
  const [a, b] = [new Uint8Array(one), new Uint8Array(other)];
  return a.length === b.length && a.every((byte, index) => byte === b[index]);
}
