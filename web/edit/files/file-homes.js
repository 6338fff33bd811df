// The files that a world can be saved to: that of tools/play, and one that the visitor has chosen,
// in browsers that let a page write it. Takes bytes; gives bytes, and tags that differ when the
// bytes do.
//
//     const home = await servedFile('-/scene/my.json');     // throws an Error in plain words
//     const home = pickedFile(handle);                      // of showOpenFilePicker and the like
//     home.name                                             // for the visitor
//     await home.read()                                     // {bytes, tag}
//     await home.write(bytes, tag)                          // the new tag; throws a Changed
//     await home.ifReadable()                               // the same as read(), or null
//     home.watch(() => ...)                                 // somebody may have written it
//
// `tag` is that of the bytes that were read: if the file has others by now, it stays as it is.

export class Changed extends Error {}

// What the server answers beside a scene (tools/scene-saves.mjs).
const kSave = '-/save';
const kEvents = '-/events';

const kLooks = 3000; // milliseconds: how often a file is looked at

export async function servedFile(address) {
  const about = await fetch(new URL(kSave, document.baseURI), { cache: 'no-store' })
    .then((answer) => (answer.ok ? answer.json() : null))
    .catch(() => null);
  if (about?.address !== address)
    throw new Error(
      'This scene was opened by tools/play, which does not serve it any more. Start it again.',
    );
  const at = new URL(address, document.baseURI);
  const read = async () => {
    const answer = await fetch(at, { cache: 'no-store' });
    if (!answer.ok)
      throw new Error(`The scene cannot be read: the server answers ${answer.status}.`);
    return { bytes: new Uint8Array(await answer.arrayBuffer()), tag: answer.headers.get('ETag') };
  };
  return {
    id: about.id,
    name: decodeURIComponent(address.split('/').at(-1)),
    at,
    read,
    ifReadable: read,
    // Not while hidden: browsers open few connections to a server at a time.
    watch(listener) {
      let events = null;
      const listen = () => {
        events?.close();
        events = document.hidden ? null : new EventSource(new URL(kEvents, document.baseURI));
        events?.addEventListener('scene', listener);
      };
      document.addEventListener('visibilitychange', listen);
      listen();
    },
    async write(bytes, tag) {
      if (about.token === null) throw new Error(about.reason);
      const answer = await fetch(at, {
        method: 'PUT',
        headers: { 'If-Match': tag, 'X-Slicecast-Token': about.token },
        body: bytes,
      }).catch(() => {
        throw new Error('tools/play does not answer. Start it again; your changes are kept here.');
      });
      if (!answer.ok) throw new Error((await answer.text()).trim());
      const { saved, tag: now } = await answer.json();
      if (!saved) throw new Changed();
      return now;
    },
  };
}

export function pickedFile(handle) {
  const read = async () => {
    const bytes = new Uint8Array(await (await handle.getFile()).arrayBuffer());
    return { bytes, tag: await tagOf(bytes) };
  };
  const may = async (mode, ask) => {
    const now = await handle.queryPermission?.({ mode });
    if (now === undefined || now === 'granted') return true; // files of the browser's own need none
    return ask && (await handle.requestPermission({ mode })) === 'granted';
  };
  return {
    name: handle.name,
    handle,
    read,
    ifReadable: async () => ((await may('read', false)) ? read().catch(() => null) : null),
    watch(listener) {
      let last = null;
      const look = async () => {
        if (document.hidden || !(await may('read', false))) return;
        const time = (await handle.getFile().catch(() => null))?.lastModified ?? last;
        if (time !== last && last !== null) listener();
        last = time;
      };
      look();
      setInterval(look, kLooks);
    },
    // The browser writes another file and exchanges them at the end.
    async write(bytes, tag) {
      if (!(await may('readwrite', true)))
        throw new Error(`The browser may not write ${handle.name}: allow it, or save a copy.`);
      const now = await read().catch((error) => {
        throw new Error(`${handle.name} is not there any more. Save a copy.`, { cause: error });
      });
      if (tag !== null && now.tag !== tag) throw new Changed();
      const file = await handle.createWritable();
      try {
        await file.write(bytes);
        await file.close();
      } catch (error) {
        await file.abort().catch(() => {});
        throw new Error(`${handle.name} could not be written: ${error.message}`, { cause: error });
      }
      return tagOf(bytes);
    },
  };
}

export async function tagOf(bytes) {
  const digest = await crypto.subtle.digest('SHA-256', bytes);
  return Array.from(new Uint8Array(digest), (byte) => byte.toString(16).padStart(2, '0')).join('');
}
