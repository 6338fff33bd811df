// Copies web/learn to build/learn and adds modules of the reader's raycaster there, one for each
// state, by-hand/chapter-NN.js, and one for each fault, by-hand/FAULT.js. The build and the bundles
// import modules from this copy.

import { cpSync, mkdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const kStaged = path.resolve('build/learn');

export async function stage({ states }) {
  rmSync(kStaged, { recursive: true, force: true });
  cpSync('web/learn', kStaged, { recursive: true });
  // The one module that the figures share with the engine stays where they import it from.
  cpSync('web/engine/nearest-name.js', path.resolve(kStaged, '../engine/nearest-name.js'));
  symlinkSync(path.resolve('tools/node_modules'), path.join(kStaged, 'node_modules'));
  const moduleAt = (name) => import(pathToFileURL(path.resolve('web/learn/raycaster', name)));
  const [{ asModule }, { faults, faultyText }] = await Promise.all(
    ['states.js', 'faults.js'].map(moduleAt),
  );
  const made = path.join(kStaged, 'by-hand');
  mkdirSync(made);
  for (let chapter = 1; chapter <= states.chapters; ++chapter) {
    const name = `chapter-${String(chapter).padStart(2, '0')}.js`;
    writeFileSync(path.join(made, name), asModule(states.answer(chapter)));
  }
  for (const name of Object.keys(faults))
    writeFileSync(path.join(made, `${name}.js`), asModule(faultyText(states, name)));
  return kStaged;
}
