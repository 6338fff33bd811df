// The folder of the shipped scenes, their pictures and tours: that of the element's script, or the
// one that the page names.
//
//     <meta name="slicecast-home" content="/art/">                     for scripts that a bundler has put elsewhere
//
//     const address = new URL('scenes/castle.json', kHome);
//     const engine = reachable(() => new URL('./...', import.meta.url), 'engine/...', kHome);

const kPage = globalThis.document?.baseURI ?? 'file:///';

// A bundler takes `new URL('...', import.meta.url)` for a file to be bundled; this is a folder to
// be asked while the page runs.
const here = import.meta.url;

export function isReachable(address, page = kPage) {
  return address.protocol !== 'file:' || page.startsWith('file:');
}

// While one develops, Vite puts packages together in a folder of its own, and leaves their other
// files behind.
const kMoved = /(?<=\/node_modules\/)\.vite\/(deps\/)?/;

// What `find` gives if this page can reach it, else what lies at that path of the folder. What a
// bundler has put together may have no address of its own, or the one that it had on the machine
// where it was built.
export function reachable(find, path, folder, page = kPage) {
  try {
    const address = find();
    if (isReachable(address, page)) return new URL(address.href.replace(kMoved, 'slicecast/'));
  } catch {
    // There is no such address.
  }
  return new URL(path, folder);
}

const told = globalThis.document?.querySelector('meta[name=slicecast-home]')?.content;

export const kHome = told
  ? new URL(told.replace(/\/?$/, '/'), kPage)
  : reachable(() => new URL('../', here), './', kPage);
