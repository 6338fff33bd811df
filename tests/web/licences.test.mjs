// The licences of the libraries in the engine, the tutorial and the editor, which must accompany
// them.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { root } from '../wasm/load.mjs';

const page = join(root, 'build/web');
const kLicences = {
  LICENSE: /^MIT License\s+Copyright \(c\) \d+ Slicecast contributors/,
  'licences/SDL2.txt': /Sam Lantinga[\s\S]*without any express or implied\s+warranty/,
  'licences/stb.txt': /Sean Barrett[\s\S]*Permission is hereby granted, free of charge/,
  'licences/RapidJSON.txt': /Milo Yip[\s\S]*Permission is hereby granted, free of charge/,
  'licences/codemirror-view.txt': /Marijn Haverbeke[\s\S]*Permission is hereby granted/,
  'licences/jsonc-parser.txt': /Microsoft[\s\S]*Permission is hereby granted/,
  'licences/fflate.txt': /Arjun Barrett[\s\S]*Permission is hereby granted/,
  'licences/idb-keyval.txt': /Apache|Jake Archibald/,
  'licences/rgrove-parse-xml.txt': /Ryan Grove/,
  'licences/zstddec.txt': /MIT/,
  'licences/minisearch.txt': /Luca Ongaro[\s\S]*Permission is hereby granted/,
  'licences/temml.txt': /Permission is hereby granted/,
  'licences/musl.txt': /Rich Felker[\s\S]*Permission is hereby granted, free of charge/,
};

test("the page holds its own licence and those of the engine's libraries", () => {
  for (const [name, expected] of Object.entries(kLicences))
    assert.match(readFileSync(join(page, name), 'utf8'), expected, name);
});

test('so does the package', () => {
  const told = execFileSync(
    'npm',
    ['pack', '--dry-run', '--json', '--ignore-scripts', '--offline'],
    {
      cwd: page,
      encoding: 'utf8',
      stdio: ['ignore', 'pipe', 'ignore'],
    },
  );
  const names = JSON.parse(told)[0].files.map(({ path }) => path);
  for (const name of Object.keys(kLicences)) assert.ok(names.includes(name), name);
});
