// The folder of the script, and with it of the shipped scenes and their pictures.
//
//     const address = new URL('scenes/castle.json', kHome);

// A bundler takes `new URL('...', import.meta.url)` for a file to be bundled; this is a folder to be asked while the page runs.
const here = import.meta.url;

export const kHome = new URL('./', here);
