// Finds the files that a module of this package names by `new URL('...', import.meta.url)`: the
// engine, and the pictures of scenes. esbuild and Rollup do not follow these themselves, so the
// plugins use this.
//
//     if (isOurs(file)) code = replaceNames(code, (path) => `another expression for ${path}`);

import { realpathSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const kPackage = realpathSync(fileURLToPath(new URL('../', import.meta.url)));
const kNamed =
  /\bnew URL\(\s*(["'`])(\.{1,2}\/[^"'`$]+\.(?:wasm|png|txt|json))\1,\s*import\.meta\.url\s*,?\s*\)/g;

// Bundlers may add a query to a file's name.
export function isOurs(file) {
  const [bare] = file.split('?');
  if (!path.isAbsolute(bare) || !bare.endsWith('.js')) return false;
  try {
    return realpathSync(bare).startsWith(kPackage);
  } catch {
    return false; // it is no file
  }
}

// `expression(path)` is JavaScript whose value is a URL.
export function replaceNames(code, expression) {
  return code.replace(kNamed, (whole, quote, named) => expression(named));
}
