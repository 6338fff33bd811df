// Notes in mutations.json which picture shows each mutation's fault, from the last run of
// `tools/test mutants`. The next run judges that picture first, and needs no search.
//
//     node tools/shown-by.mjs

import { readFileSync, writeFileSync } from 'node:fs';
import process from 'node:process';

const kMutations = new URL('../tests/judge/mutations.json', import.meta.url);
const kResults = new URL('../build/clang/results/ctest.xml', import.meta.url);

const shownBy = new Map(
  readFileSync(kResults, 'utf8')
    .split('<testcase ')
    .map((text) => [
      text.match(/^name="mutant_([^"]*)"/)?.[1],
      text.match(/^.*?\b([a-z]+ \d+) shows it/m)?.[1],
    ]),
);
const mutations = JSON.parse(readFileSync(kMutations, 'utf8'));
let changed = 0;
for (const mutation of mutations) {
  const found = shownBy.get(mutation.name);
  if (found === undefined || found === mutation.shownBy) continue;
  mutation.shownBy = found;
  changed += 1;
}
writeFileSync(kMutations, `${JSON.stringify(mutations, null, 2)}\n`);
process.stdout.write(`${changed} of ${mutations.length} mutations are shown by another picture.\n`);
