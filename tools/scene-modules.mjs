// Makes a module of each shipped scene, beside its file: scenes/castle.js. Its default export is
// the scene as an object that names its pictures by `new URL('...', import.meta.url)`, which
// bundlers follow; they cannot follow the plain file names of a scene file. `tour` is the address
// of the scene's tour, if it has one.
//
//     node tools/scene-modules.mjs FOLDER        // a built page with scenes and pictures
//
// The module registers itself with the element, so that scene="castle" means this module. So a
// page, and a server that renders it, needs only the name.

import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import process from 'node:process';

const kPicture = /^\.\.\/[^/]+\/[^/]+\.png$/;
const kNotes = ['$schema', 'comment']; // only for authors

const [folder] = process.argv.slice(2);
if (folder === undefined)
  throw new Error('tools/scene-modules.mjs: found no folder, expected that of a built page');
const scenes = resolve(folder, 'scenes');

for (const { file, title, tour } of JSON.parse(readFileSync(join(scenes, 'index.json'), 'utf8'))) {
  const name = file.replace(/\.json$/, '');
  try {
    const { script, types } = moduleOf(name, title, tour === true);
    writeFileSync(join(scenes, `${name}.js`), script);
    writeFileSync(join(scenes, `${name}.d.ts`), types);
  } catch (error) {
    console.error(`${file}: ${error.message}; there is no module of it.`);
  }
}

function moduleOf(name, title, hasTour) {
  const scene = JSON.parse(readFileSync(join(scenes, `${name}.json`), 'utf8'));
  for (const note of kNotes) delete scene[note];
  const paths = picturesIn(scene);
  const constants = paths.map((path, index) => `const p${index} = ${found(name, path)};`);
  // Replaces each picture's name by a constant.
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

// A literal address, so that bundlers find the file.
function found(name, path) {
  if (!existsSync(join(scenes, path)))
    throw new Error(`tools/scene-modules.mjs: scenes/${name}: there is no file ${path}`);
  return `/* @__PURE__ */ at('${path}', () => new URL('${path}', import.meta.url))`;
}
