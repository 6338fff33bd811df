// Bundles the page's scripts. Each script and all its imports become one small file, so that a page
// makes one request instead of thirty in several rounds. What the element needs only later is in
// files of its own.
//
//     node tools/bundle.mjs FOLDER        // bundles FOLDER/ray-caster.js and the others
//
// Modules that nothing else needs are removed; what Node imports stays.

import { readFile, readdir, rm, writeFile } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { build, transform } from 'esbuild';

const [folder] = process.argv.slice(2);
if (folder === undefined)
  throw new Error('tools/bundle.mjs: found no folder, expected one that holds ray-caster.js');
const kElement = [
  'ray-caster.js',
  'ray-caster-steering.js',
  'ray-caster-rows.js',
  'ray-caster-more.js',
  'ray-caster-sound.js',
];
const kPages = [
  'embed.js',
  'play/main.js',
  'edit/main.js',
  'edit/hand-over.js',
  'edit/text-view.js',
  'edit/import.js',
];
const kPlayer = ['edit/player/boot.js', 'edit/player/main.js']; // of tools/player-page.mjs
// Of these; scripts load them when wanted.
const kLater = ['edit/hand-over.js', 'edit/text-view.js', 'edit/import.js'];
// These stay: Node's command uses the modules.
const kForNode = [
  path.join('edit', 'import', path.sep),
  ...['html-file.js', 'dense-text.js', 'share-texts.js', 'shipped.js', 'text-form.js'].map((name) =>
    path.join('edit', 'files', name),
  ),
];
const inFolder = (name) => path.resolve(folder, name);
const kSmall = { target: 'es2022', minify: true, legalComments: 'none', logLevel: 'warning' };

// Style sheets are texts in the modules, `const kSheet = ...`.
const smallSheets = {
  name: 'small sheets',
  setup: ({ onLoad }) =>
    onLoad({ filter: /styles\.js$/ }, async ({ path: file }) => {
      const text = await readFile(file, 'utf8');
      const [whole, sheet] = /(?<=const kSheet = )`([^`]*)`/.exec(text);
      const { code } = await transform(sheet, { loader: 'css', minify: true });
      return { contents: text.replace(whole, () => JSON.stringify(code.trim())) };
    }),
};

const { version } = JSON.parse(await readFile(inFolder('package.json'), 'utf8'));
const versionOfPackage = {
  name: 'version',
  setup: ({ onLoad }) =>
    onLoad({ filter: /[\\/]element[\\/]version\.js$/ }, () => ({
      contents: `export const version = ${JSON.stringify(version)};`,
    })),
};

// Makes addresses relative to the bundle instead of the module.
const addressesFrom = (script) => ({
  name: 'addresses',
  setup: ({ onLoad }) =>
    onLoad({ filter: /[\\/](home|engine-files)\.js$/ }, async ({ path: file }) => {
      const text = await readFile(file, 'utf8');
      const moved = (address) => {
        const to = path
          .relative(path.dirname(script), path.resolve(path.dirname(file), address))
          .split(path.sep)
          .join('/');
        const whole = to === '' || to.startsWith('.') ? to : `./${to}`;
        return address.endsWith('/') ? `${whole || '.'}/` : whole;
      };
      return {
        contents: text.replaceAll(
          /(?<=new URL\(')(\.[^']*)(?=', (?:import\.meta\.url|here)\))/g,
          moved,
        ),
      };
    }),
});

// The page that plays from a disk has all in one script, and its engine in itself.
const inOneFile = {
  name: 'in one file',
  setup({ onLoad, onResolve }) {
    onResolve({ filter: /engine-files\.js$/ }, () => ({
      path: inFolder('edit/player/engine-files.js'),
    }));
    onLoad({ filter: /[\\/]ray-caster-rows\.js$/ }, () => ({ contents: '' })); // it has JSON
  },
};

const bundle = async (script, external, more = []) => {
  const {
    metafile: { inputs },
    outputFiles: [{ text }],
  } = await build({
    ...kSmall,
    entryPoints: [script],
    outfile: script,
    write: false,
    bundle: true,
    metafile: true,
    format: 'esm',
    external: external.filter((other) => other !== script),
    nodePaths: [fileURLToPath(new URL('node_modules', import.meta.url))],
    plugins: [...more, smallSheets, versionOfPackage, addressesFrom(script)],
  });
  return { script, text, modules: Object.keys(inputs).map((name) => path.resolve(name)) };
};

const scripts = kElement.map(inFolder);
const bundles = await Promise.all([
  ...scripts.map((script) => bundle(script, scripts)),
  ...kPages.map((name) => bundle(inFolder(name), [...scripts, ...kLater.map(inFolder)])),
  ...kPlayer.map((name) => bundle(inFolder(name), [], [inOneFile])),
]);
for (const { script, text } of bundles) {
  // Bundlers cannot follow an address that is known only at run time. Minifying removes the comment
  // that tells them so; this puts it back.
  const followed = text.replaceAll(/\bimport\((?!")/g, 'import(/* @vite-ignore */ ');
  await writeFile(
    script,
    `// Of Slicecast's page, in one file, made of the modules of its folder web.\n${followed}`,
  );
}

// The licences of the libraries in the bundles must accompany them.
const libraries = new Set(
  bundles
    .flatMap(({ modules }) => modules)
    .map((module) => /^.*\/node_modules\/(@[^/]+\/)?[^/]+/.exec(module.replaceAll('\\', '/'))?.[0])
    .filter((library) => library !== undefined),
);
for (const library of libraries) {
  const name = /node_modules\/([^]*)$/.exec(library)[1].replace('@', '').replace('/', '-');
  const file = (await readdir(library)).find((one) => /^licen[cs]e/i.test(one));
  const { license, author } = JSON.parse(
    await readFile(path.join(library, 'package.json'), 'utf8'),
  );
  const text =
    file === undefined
      ? `${license}\n${JSON.stringify(author ?? '')}\n`
      : await readFile(path.join(library, file), 'utf8');
  await writeFile(inFolder(path.join('licences', `${name}.txt`)), text);
}

const kept = new Set(bundles.map(({ script }) => script));
const bundled = new Set(bundles.flatMap(({ modules }) => modules));
for (const module of bundled) {
  const [part] = path.relative(folder, module).split(path.sep);
  const isOnlyThere =
    ['element', 'play', 'sound', 'edit'].includes(part) &&
    !kForNode.some((kept) => path.relative(folder, module).startsWith(kept));
  if (isOnlyThere && !kept.has(module)) await rm(module);
}
