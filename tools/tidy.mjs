// Runs clang-tidy over src, on all cores. What has passed is not looked at again until a file or a
// header of it, .clang-tidy or the program changes.
//
//   node tools/tidy.mjs BUILD CACHE     BUILD: a folder with compile_commands.json, for clang
//
// In a unity build a part of src is one file, which includes the part's own: so its headers, which
// take nearly all of the time, are read once.

import { execFile } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const kRepo = path.join(path.dirname(fileURLToPath(import.meta.url)), '..');
const [build, cache] = process.argv.slice(2);

// The status and all output of a command.
function run(command, args, cwd) {
  return new Promise((resolve) => {
    execFile(command, args, { cwd, maxBuffer: 1 << 28 }, (error, stdout, stderr) => {
      resolve({ status: error ? (error.code ?? 1) : 0, stdout, stderr });
    });
  });
}

const settings = readFileSync(path.join(kRepo, '.clang-tidy'), 'utf8');
const { stdout: version } = await run('clang-tidy', ['--version'], kRepo);

// What clang-tidy will see of a file, as a name in the cache.
async function stampOf({ command, directory }) {
  // Everything but where the object goes; comments stay, for NOLINT is one.
  const words = command
    .split(' ')
    .filter((word) => word !== '')
    .filter((word, i, all) => word !== '-o' && all[i - 1] !== '-o' && word !== '-c');
  const start = words.findIndex((word) => word.endsWith('clang++'));
  const { status, stdout } = await run(
    words[start],
    [...words.slice(start + 1), '-E', '-P', '-C'],
    directory,
  );
  if (status !== 0) return null;
  const hash = createHash('sha256').update(version).update(settings);
  return path.join(cache, hash.update(stdout).digest('hex'));
}

async function isClean(entry) {
  const stamp = await stampOf(entry);
  if (stamp !== null && existsSync(stamp)) return true;
  const { status, stdout, stderr } = await run(
    'clang-tidy',
    // A unity file includes sources, as it should.
    [
      ...['-p', build, '--quiet', '--warnings-as-errors=*'],
      ...['--checks=-bugprone-suspicious-include', entry.file],
    ],
    kRepo,
  );
  if (status === 0) {
    if (stamp !== null) writeFileSync(stamp, '');
    return true;
  }
  process.stdout.write(stdout || stderr);
  return false;
}

mkdirSync(cache, { recursive: true });
const folders = [path.join(kRepo, 'src'), path.join(path.resolve(build), 'src')];
const entries = JSON.parse(readFileSync(path.join(build, 'compile_commands.json'), 'utf8'))
  .filter(({ file }) => folders.some((folder) => file.startsWith(folder + path.sep)))
  // The judge compiles the renderer once more, for its mutations
  .filter(({ command }) => command.includes(' -o src/'))
  .filter(({ file }, i, all) => all.findIndex((other) => other.file === file) === i);
if (entries.length === 0) {
  console.error(`tidy: ${build} compiles nothing of ${folders[0]}`);
  process.exit(1);
}
let failures = 0;
const left = [...entries];
async function work() {
  while (left.length > 0) if (!(await isClean(left.shift()))) ++failures;
}
await Promise.all(Array.from({ length: availableParallelism() }, work));
console.log(`clang-tidy: ${entries.length} files, ${failures} with warnings`);
process.exit(failures > 0 ? 1 : 0);
