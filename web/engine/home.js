// The folder of the shipped scenes, pictures and tours: that of the element's script, or the one
// that the page names because a bundler has moved the script.
//
//     <meta name="slicecast-home" content="/art/">
//
//     const address = new URL('scenes/castle.json', kHome);
//     const engine = reachable(() => new URL('./...', import.meta.url), 'engine/...', kHome);

const kPage = globalThis.document?.baseURI ?? 'file:///';

// Kept apart: bundlers take `new URL('...', import.meta.url)` for a file to bundle, but this is a
// folder to fetch from at run time.
const here = import.meta.url;

export function isReachable(address, page = kPage) {
  return address.protocol !== 'file:' || page.startsWith('file:');
}

// Vite's development server bundles packages into a folder of its own but leaves their other files
// behind.
const kMoved = /(?<=\/node_modules\/)\.vite\/(deps\/)?/;

// Returns find() if this page can reach that address, else that path in the folder. A bundled
// script may have no address, or the one that it had on the build machine.
export function reachable(find, path, folder, page = kPage) {
  try {
    const address = find();
    if (isReachable(address, page)) return new URL(address.href.replace(kMoved, 'slicecast/'));
  } catch {
    // There is no such address.
  }
  return new URL(path, folder);
}

const named = globalThis.document?.querySelector('meta[name=slicecast-home]')?.content;

export const kHome = named
  ? new URL(named.replace(/\/?$/, '/'), kPage)
  : reachable(() => new URL('../', here), './', kPage);
