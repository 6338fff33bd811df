// A scene of the served page as a source, for tests that run engines without the element.

import { fetchBytes } from './engine/fetch-bytes.js';
import { filesBy, nameOf } from './engine/source-parts.js';

export function sceneAt(name) {
  const address = new URL(`scenes/${name}.json`, document.baseURI);
  return {
    name: nameOf(address),
    readText: () => fetchBytes(address),
    ...filesBy((file, onBytes) => fetchBytes(new URL(file, address), onBytes)),
  };
}
