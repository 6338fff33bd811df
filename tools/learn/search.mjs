// Writes the index of the tutorial's search: each section of each chapter is a document.

import MiniSearch from 'minisearch';
import { readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';

const kFields = {
  fields: ['title', 'chapter', 'text'],
  storeFields: ['title', 'chapter', 'address'],
};

const plain = (html) =>
  html
    .replaceAll(/<(svg|math|script|style|noscript|pre)\b[\s\S]*?<\/\1>/g, ' ')
    .replaceAll(/<[^>]+>/g, ' ')
    .replaceAll('&lt;', '<')
    .replaceAll('&gt;', '>')
    .replaceAll('&amp;', '&')
    .replaceAll(/\s+/g, ' ')
    .trim();

export async function writeSearch(output, chapters) {
  const index = new MiniSearch(kFields);
  for (const { name, number } of chapters.values()) {
    const page = await readFile(path.join(output, `${name}.html`), 'utf8');
    const main = /<main[^>]*>([\s\S]*?)<(?:section class="write"|nav class="onward")/.exec(page)[1];
    const title = plain(/<h1>([\s\S]*?)<\/h1>/.exec(main)[1]);
    const parts = main.split(/(?=<h2 id=)/);
    parts.forEach((part, at) => {
      const [, id, heading] = /^<h2 id="([^"]+)"[^>]*>([\s\S]*?)<\/h2>/.exec(part) ?? [];
      index.add({
        id: `${number}-${at}`,
        title: id === undefined ? title : plain(heading),
        chapter: `Chapter ${number}: ${title}`,
        address: `${name}.html${id === undefined ? '' : `#${id}`}`,
        text: plain(part),
      });
    });
  }
  await writeFile(path.join(output, 'search.json'), JSON.stringify(index));
}
