// A Rollup plugin: copies the engine and the pictures of imported scenes into the output folder.
//
//     import slicecast from 'slicecast/rollup';
//     export default { plugins: [nodeResolve(), slicecast()] };

import { readFile } from 'node:fs/promises';
import path from 'node:path';

import { isOurs, replaceNames } from './named-files.js';

export default function slicecast() {
  return {
    name: 'slicecast',
    async transform(code, id) {
      if (!isOurs(id)) return null;
      const [file] = id.split('?');
      const references = new Map();
      replaceNames(code, (named) => references.set(named, null));
      for (const named of references.keys()) {
        const source = await readFile(path.resolve(path.dirname(file), named));
        const name = path.basename(named);
        references.set(named, this.emitFile({ type: 'asset', name, source }));
      }
      if (references.size === 0) return null;
      // A classic script can read its address only while it first runs.
      const nameOf = (named) => `slicecastFile${[...references.keys()].indexOf(named)}`;
      const lines = Array.from(
        references,
        ([named, id]) => `const ${nameOf(named)} = import.meta.ROLLUP_FILE_URL_${id};`,
      );
      const followed = replaceNames(code, (named) => `new URL(${nameOf(named)})`);
      return { code: `${lines.join('\n')}\n${followed}`, map: null };
    },
  };
}
