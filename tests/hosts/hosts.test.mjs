// Installs the packed file in other projects and uses it: in a plain page; in apps and sites built
// by Vite, webpack, Rollup, esbuild, Astro and VitePress; in one that React renders on the server;
// and in a program under Node. Needs build/slicecast-VERSION.tgz (tools/package), and nothing from
// the network.

import assert from 'node:assert/strict';
import { execFile, spawn } from 'node:child_process';
import { createHash } from 'node:crypto';
import { cp, mkdir, readFile, readdir, rm, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { build } from 'esbuild';
import { rollup } from 'rollup';
import webpack from 'webpack';

import { launch } from '../browser/browser.mjs';
import { serve } from '../browser/static-server.mjs';
import { crashToo } from '../node/crash.mjs';

const hosts = fileURLToPath(new URL('.', import.meta.url));
const root = path.join(hosts, '../..');
const installed = path.join(hosts, 'node_modules/slicecast');
const built = path.join(root, 'build/hosts');
const shared = path.join(built, 'public'); // what an app's own folder of files holds: the shipped scenes and their pictures

const kArt = ['scenes', 'textures', 'see-through', 'sheets', 'sprites', 'tours'];
const kSize = { width: 320, height: 200 };
const kWaitMilliseconds = 15000;
const kToolMilliseconds = 90000;

const run = promisify(execFile);
let tarball;
let browser;
let expected; // the picture's bytes, hashed

before(async () => {
  const names = (await readdir(path.join(root, 'build'))).filter((name) =>
    /^slicecast-.*\.tgz$/.test(name),
  );
  assert.equal(names.length, 1, 'one packed file in build/, by tools/package');
  tarball = path.join(root, 'build', names[0]);
  await rm(installed, { recursive: true, force: true });
  await run(
    'npm',
    [
      'install',
      '--no-save',
      '--offline',
      '--legacy-peer-deps', // or it asks the network for versions that fit better
      '--no-audit',
      '--no-fund',
      '--ignore-scripts',
      tarball,
    ],
    { cwd: hosts },
  );
  await rm(built, { recursive: true, force: true });
  // By an address they may lie anywhere; by their names they are looked for beside the built
  // script.
  for (const place of ['slicecast', 'assets']) {
    for (const name of kArt)
      await cp(path.join(installed, name), path.join(shared, place, name), { recursive: true });
  }

  const { load } = await import('slicecast/node');
  const scene = await load('first-walk');
  expected = hashOf(scene.pixels(kSize).data);
  scene.free();
  browser = await launch();
});

after(() => browser?.close());

function hashOf(bytes) {
  return createHash('sha256').update(bytes).digest('hex');
}

// The element at an address draws the scene's picture, a click plays it, and nothing in the page
// complains.
async function assertDraws(address, look = () => {}) {
  const page = await browser.newPage({ viewport: { width: 800, height: 600 } });
  page.setDefaultTimeout(kWaitMilliseconds);
  const complaints = [];
  page.on(
    'console',
    (message) => ['error', 'warning'].includes(message.type()) && complaints.push(message.text()),
  );
  page.on('pageerror', (error) => complaints.push(String(error)));
  try {
    await page.goto(address);
    await page
      .waitForFunction(() => customElements.get('ray-caster') !== undefined)
      .catch(() => assert.fail(`the element is not defined: ${complaints.join('\n')}`));
    const found = await page.evaluate(async () => {
      const elements = [...document.querySelectorAll('ray-caster')];
      await Promise.all(elements.map((element) => element.whenReady().catch(() => {})));
      const fault = elements.find(({ error }) => error !== null);
      if (fault !== undefined) return fault.error;
      const [element] = elements;
      const canvas = element.shadowRoot.querySelector('canvas');
      const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', data));
      return [...digest].map((byte) => byte.toString(16).padStart(2, '0')).join('');
    });
    assert.deepEqual(found, expected);
    await page.click('ray-caster');
    await page.waitForFunction(() => document.querySelector('ray-caster').state === 'playing');
    await look(page);
    assert.deepEqual(complaints, []);
  } finally {
    await page.close();
  }
}

async function assertFolderDraws(folder, look) {
  const server = await serve({ folder });
  try {
    await assertDraws(server.address, look);
  } finally {
    await server.close();
  }
}

// The hosts' tools run as commands, as users run them. The folder of shared files
// is passed in a variable.
const toolOptions = {
  cwd: hosts,
  env: {
    ...process.env,
    SLICECAST_PUBLIC: shared,
    SLICECAST_CACHE: path.join(built, 'cache'),
    SLICECAST_OUT: path.join(built, 'astro'),
    ASTRO_TELEMETRY_DISABLED: '1',
    NO_COLOR: '1',
  },
};

function runTool(file, words) {
  return run(process.execPath, [path.join(hosts, 'node_modules', file), ...words], {
    ...toolOptions,
    timeout: kToolMilliseconds,
  }).catch(crashToo);
}

// Starts a server: returns its address, once printed, and a function that stops it.
function startTool(file, words) {
  const child = spawn(process.execPath, [path.join(hosts, 'node_modules', file), ...words], {
    ...toolOptions,
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  const ended = new Promise((resolve) => child.on('close', resolve));
  const address = new Promise((resolve, reject) => {
    let said = '';
    const hear = (text) => {
      said += text;
      const found = /http:\/\/localhost:\d+\//.exec(said);
      if (found !== null) resolve(found[0]);
    };
    child.stdout.on('data', hear);
    child.stderr.on('data', hear);
    ended.then(() => reject(new Error(`${file} ends: ${said}`)));
  });
  return {
    address,
    end() {
      child.kill();
      return ended;
    },
  };
}

test('a plain page beside the copied folder', async () => {
  const folder = path.join(built, 'plain');
  await cp(path.join(hosts, 'plain'), folder, { recursive: true });
  await cp(installed, path.join(folder, 'slicecast'), { recursive: true });
  await assertFolderDraws(folder);
});

test('an app that Vite builds', async () => {
  const outDir = path.join(built, 'vite');
  await runTool('vite/bin/vite.js', [
    'build',
    'vite',
    '--outDir',
    outDir,
    '--emptyOutDir',
    '--logLevel',
    'warn',
  ]);
  await assertFolderDraws(outDir);
});

test("an app on Vite's development server", async () => {
  const server = startTool('vite/bin/vite.js', ['vite', '--host', 'localhost', '--port', '5190']);
  try {
    await assertDraws(await server.address);
  } finally {
    await server.end();
  }
});

// From here on the scene is imported, and the apps have only installed files.

test('an app that Vite builds, with an imported scene', async () => {
  const outDir = path.join(built, 'vite-app');
  await runTool('vite/bin/vite.js', ['build', 'app', '--outDir', outDir, '--logLevel', 'warn']);
  await assertFolderDraws(outDir);
});

test("an app on Vite's development server without settings, with an imported scene", async () => {
  await rm(path.join(hosts, 'node_modules/.vite'), { recursive: true, force: true });
  const server = startTool('vite/bin/vite.js', ['app', '--host', 'localhost', '--port', '5191']);
  try {
    await assertDraws(await server.address);
  } finally {
    await server.end();
  }
});

// Puts the app's page beside its built script.
async function writePage(folder, script, tag = '<script type="module"') {
  const page = await readFile(path.join(hosts, 'app/index.html'), 'utf8');
  await writeFile(
    path.join(folder, 'index.html'),
    page.replace('<script type="module" src="./main.js"', `${tag} src="${script}"`),
  );
}

for (const mode of ['development', 'production']) {
  test(`an app that webpack builds for ${mode}`, async () => {
    const folder = path.join(built, `webpack-${mode}`);
    await runWebpack({ mode, entry: './app/main.js', output: { path: folder, clean: true } });
    await writePage(folder, 'main.js', '<script defer');
    await assertFolderDraws(folder);
  });
}

async function runWebpack(settings) {
  const result = await promisify(webpack)({ context: hosts, performance: false, ...settings });
  assert.deepEqual(result.compilation.errors.map(String), []);
  assert.deepEqual(result.compilation.warnings.map(String), []);
}

for (const [format, tag] of [
  ['es', '<script type="module"'],
  ['iife', '<script defer'],
]) {
  test(`an app that Rollup builds with the package's plugin: ${format}`, async () => {
    const { default: slicecast } = await import('slicecast/rollup');
    const folder = path.join(built, `rollup-${format}`);
    const bundle = await rollup({
      input: path.join(hosts, 'app/main.js'),
      plugins: [nodeResolution, slicecast()],
      onwarn: ({ message }) => assert.fail(message),
    });
    await bundle.write({
      dir: path.join(folder, 'scripts'),
      format,
      inlineDynamicImports: format === 'iife',
    });
    await bundle.close();
    await writePage(folder, 'scripts/main.js', tag);
    await assertFolderDraws(folder);
  });
}

// The plugin that every Rollup build needs.
const nodeResolution = {
  name: 'packages',
  resolveId: (name) =>
    /^slicecast\b/.test(name) ? fileURLToPath(import.meta.resolve(name)) : null,
};

for (const [format, tag] of [
  ['esm', '<script type="module"'],
  ['iife', '<script defer'],
]) {
  test(`an app that esbuild builds with the package's plugin: ${format}`, async () => {
    const { default: slicecast } = await import('slicecast/esbuild');
    const folder = path.join(built, `esbuild-plugin-${format}`);
    const { warnings } = await build({
      entryPoints: [path.join(hosts, 'app/main.js')],
      outdir: path.join(folder, 'scripts'),
      bundle: true,
      splitting: format === 'esm',
      format,
      plugins: [slicecast()],
      logLevel: 'silent',
    });
    assert.deepEqual(warnings, []);
    await writePage(folder, 'scripts/main.js', tag);
    await assertFolderDraws(folder);
  });
}

test('without the plugin, the app that esbuild builds says what to do', async () => {
  const folder = path.join(built, 'esbuild-alone');
  await build({
    entryPoints: [path.join(hosts, 'app/main.js')],
    outdir: folder,
    bundle: true,
    format: 'esm',
  });
  await writePage(folder, 'main.js');
  const server = await serve({ folder });
  const page = await browser.newPage();
  try {
    await page.goto(server.address);
    const { message } = await page.evaluate(async () => {
      const element = document.querySelector('ray-caster');
      return element.whenReady().catch(() => element.error);
    });
    assert.match(message, /slicecast-simd\.wasm: the server answers 404.*"With a bundler"/);
  } finally {
    await page.close();
    await server.close();
  }
});

const astroSettings = ['--root', '.', '--config', 'astro/astro.config.mjs'];

test('a site that Astro builds', async () => {
  await runTool('astro/astro.js', ['build', ...astroSettings, '--silent']);
  await assertFolderDraws(path.join(built, 'astro'));
});

test("a site on Astro's development server", async () => {
  const words = ['dev', ...astroSettings, '--port', '5192'];
  const server = startTool('astro/astro.js', words);
  try {
    await assertDraws(await server.address);
  } finally {
    await server.end();
  }
});

// The server writes the tag with the name of the scene, which the browser's script has imported.
test('an app that React renders on the server and in the browser', async () => {
  const { default: slicecast } = await import('slicecast/esbuild');
  const folder = path.join(built, 'react');
  await build({
    entryPoints: { main: path.join(hosts, 'react/browser.js') },
    outdir: folder,
    bundle: true,
    format: 'esm',
    define: { 'process.env.NODE_ENV': '"production"' },
    plugins: [slicecast()],
  });
  const { stdout } = await run(process.execPath, [path.join(hosts, 'react/server.mjs')]).catch(
    crashToo,
  );
  assert.match(
    stdout,
    /<ray-caster scene="first-walk" size="320x200" controls="" label="The first walk"><\/ray-caster>/,
  );
  await writeFile(path.join(folder, 'index.html'), stdout);
  await assertFolderDraws(folder, (page) =>
    page.waitForFunction(() =>
      ['h1', 'h2'].every((name) => document.querySelector(name)?.textContent === 'First walk'),
    ),
  );
});

// Bundlers that follow no files: the engine is beside the script or, if the script does not know
// its address, in the folder that the page names.
for (const [format, tag, engine] of [
  ['esm', '<script type="module"', 'engine'],
  ['iife', '<script defer', 'slicecast/engine'],
]) {
  test(`an app that esbuild bundles into one script: ${format}`, async () => {
    const folder = path.join(built, `esbuild-${format}`);
    await cp(path.join(shared, 'slicecast'), path.join(folder, 'slicecast'), { recursive: true });
    await cp(path.join(installed, 'engine'), path.join(folder, engine), { recursive: true });
    await build({
      entryPoints: [path.join(hosts, 'vite/main.js')],
      outfile: path.join(folder, 'main.js'),
      bundle: true,
      format,
      logLevel: 'error',
    });
    const page = await readFile(path.join(hosts, 'vite/index.html'), 'utf8');
    const home = '<meta name="slicecast-home" content="/slicecast">';
    await writeFile(
      path.join(folder, 'index.html'),
      page
        .replace('<script type="module"', `${home}\n${tag}`)
        .replace('"/slicecast/scenes/first-walk.json"', '"first-walk"'),
    );
    await assertFolderDraws(folder);
  });
}

test('a site that VitePress builds, its pages drawn on the server', async () => {
  const outDir = path.join(built, 'vitepress');
  await runTool('vitepress/bin/vitepress.js', ['build', 'vitepress', '--outDir', outDir]);
  assert.match(
    await readFile(path.join(outDir, 'index.html'), 'utf8'),
    /<ray-caster scene="\/slicecast\/scenes\/first-walk.json"/,
  );
  await assertFolderDraws(outDir);
});

test('a program under Node', async () => {
  const file = path.join(built, 'first-walk.png');
  await mkdir(built, { recursive: true });
  await run(process.execPath, [path.join(hosts, 'node/draw.mjs'), file]).catch(crashToo);
  const { decode } = await import('fast-png');
  const { width, height, data } = decode(await readFile(file));
  assert.deepEqual({ width, height, hash: hashOf(data) }, { ...kSize, hash: expected });
});

test('the command that imports maps', async () => {
  const folder = path.join(built, 'import');
  await rm(folder, { recursive: true, force: true });
  await mkdir(folder, { recursive: true });
  await writeFile(path.join(folder, 'maze.txt'), '1 1 1\n1 0 1\n1 1 1\n');
  const command = path.join(hosts, 'node_modules/.bin/slicecast');
  const { stdout } = await run(command, ['import', 'maze.txt'], { cwd: folder });
  assert.match(stdout, /^Wrote maze-scene\.json and 2 pictures\./);
});

test('the script is found by each of its names, and no unneeded file is packed', async () => {
  const { resolve } = createRequire(import.meta.url);
  const { main } = JSON.parse(await readFile(resolve('slicecast/package.json'), 'utf8'));
  const script = path.join(installed, 'ray-caster.js');
  assert.deepEqual(
    [resolve('slicecast'), resolve('slicecast/ray-caster.js'), path.join(installed, main)],
    [script, script, script],
  );
  const packed = await readdir(installed);
  for (const name of ['element', 'pictures']) assert.ok(!packed.includes(name), name);
});

test('publint finds nothing', async () => {
  await run(process.execPath, [
    path.join(root, 'tests/node_modules/publint/src/cli.js'),
    tarball,
    '--strict',
  ]);
});

// It mistakes a page, which nobody imports, for a module.
test(
  'the types are right',
  { skip: Number(process.versions.node.split('.')[0]) < 20 && 'its tool needs Node 20' },
  async () => {
    const tool = path.join(root, 'tests/node_modules/@arethetypeswrong/cli/dist/index.js');
    await run(process.execPath, [
      tool,
      tarball,
      '--profile',
      'esm-only',
      '--exclude-entrypoints',
      'embed.html',
      'figures.css',
      '--no-color',
    ]);
  },
);
