// Makes a module of each shipped scene, beside its file: scenes/castle.js, whose default export is
// the scene as an object that names its pictures by `new URL('...', import.meta.url)`. Bundlers
// follow these; a scene file names its pictures as plain texts, which they cannot follow. `tour` is
// the address of the scene's recorded tour, where it has one.
//
//     node tools/scene-modules.mjs FOLDER        // of a built page, which holds scenes and pictures
//
// The module tells the element of itself, so that scene="castle" means it: then the name alone is
// in the page, which servers can write.

import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import process from 'node:process';

const kPicture = /^\.\.\/[^/]+\/[^/]+\.png$/;
const kNotes = ['$schema', 'comment']; // for those who write the scene

const [folder] = process.argv.slice(2);
if (folder === undefined)
  throw new Error('tools/scene-modules.mjs: found no folder, expected that of a built page');
const scenes = resolve(folder, 'scenes');

for (const { file, title, tour } of JSON.parse(readFileSync(join(scenes, 'index.json'), 'utf8'))) {
  const name = file.replace(/\.json$/, '');
  const { script, types } = moduleOf(name, title, tour === true);
  writeFileSync(join(scenes, `${name}.js`), script);
  writeFileSync(join(scenes, `${name}.d.ts`), types);
}

function moduleOf(name, title, hasTour) {
  const scene = JSON.parse(readFileSync(join(scenes, `${name}.json`), 'utf8'));
  for (const note of kNotes) delete scene[note];
  const paths = picturesIn(scene);
  const constants = paths.map((path, index) => `const p${index} = ${found(name, path)};`);
  // Each picture is a constant, and where it is named that constant stands.
  const text = JSON.stringify(scene).replace(/"(\.\.\/[^"]+)"/g, (quoted, path) =>
    paths.includes(path) ? `p${paths.indexOf(path)}` : quoted,
  );
  const tour = hasTour ? `export const tour = ${found(name, `../tours/${name}.txt`)}.href;\n` : '';
  return {
    script: `// ${title}: made from ${name}.json. An output that has no import.meta.url finds the pictures from the page.

const at = (path, find) => {
  try {
    return find();
  } catch {
    return new URL(path, 'file:///scenes/');
  }
};
${constants.join('\n')}

const scene = ${text};
${tour}
(globalThis[Symbol.for('slicecast.scenes')] ??= new Map()).set('${name}', { scene${hasTour ? ', tour' : ''} });

export default scene;
`,
    types: `import type { SceneObject } from '../shapes.js';

/** ${title}. */
declare const scene: SceneObject;
export default scene;
${hasTour ? '\n/** The address of its tour. */\nexport declare const tour: string;\n' : ''}`,
  };
}

function picturesIn(scene) {
  const paths = new Set();
  JSON.stringify(scene, (key, value) => {
    if (typeof value === 'string' && kPicture.test(value)) paths.add(value);
    return value;
  });
  return [...paths];
}

// The address stands in it as a literal: that is how bundlers find the file.
function found(name, path) {
  if (!existsSync(join(scenes, path)))
    throw new Error(`tools/scene-modules.mjs: scenes/${name}: there is no file ${path}`);
  return `/* @__PURE__ */ at('${path}', () => new URL('${path}', import.meta.url))`;
}
