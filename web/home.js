// The folder of the script, and with it of the shipped scenes and their pictures.
//
//     const address = new URL('scenes/castle.json', kHome);

// A bundler takes `new URL('...', import.meta.url)` for a file to be bundled; this is a folder to be asked while the page runs.
const here = import.meta.url;

// Where a script has no address, bundled for a server or as a classic script, the page's own stands in.
export const kHome = new URL('./', here ?? globalThis.document?.baseURI ?? 'file:///');
