// Eleventy's configuration for the documentation: Markdown without a template language, one layout
// (page.njk), addresses that end in .html, and relative links, so that the folder works anywhere.

import { readFileSync } from 'node:fs';

import { Catalogue } from './catalogue.mjs';
import { markdown } from './markdown.mjs';
import { Pictures } from './pictures.mjs';

const kVersion = /project\(Slicecast VERSION ([0-9.]+)/;

// `folder` is the built page; its engine draws the pictures.
export function configure(config, folder) {
  const pictures = new Pictures(folder);

  config.setLibrary('md', markdown(pictures, new Catalogue()));
  config.setIncludesDirectory('../../tools/docs');
  config.setTemplateFormats(['md']);
  config.addGlobalData('layout', 'page.njk');
  config.addGlobalData(
    'permalink',
    () =>
      ({ page }) =>
        `${page.fileSlug || 'index'}.html`,
  );
  config.addGlobalData('version', kVersion.exec(readFileSync('CMakeLists.txt', 'utf8'))[1]);

  // The pages in the order of their front matter, in groups: [{title, pages}].
  config.addCollection('groups', (all) => {
    const groups = new Map();
    const pages = all.getAll().sort((left, right) => left.data.order - right.data.order);
    for (const page of pages) {
      for (const key of ['title', 'description', 'order', 'group']) {
        if (page.data[key] === undefined)
          throw new Error(`${page.inputPath}: its front matter has no "${key}".`);
      }
      if (!groups.has(page.data.group)) groups.set(page.data.group, []);
      groups.get(page.data.group).push(page);
    }
    return [...groups].map(([title, members]) => ({ title, pages: members }));
  });

  // The h2 headings of a page: [{id, title}].
  config.addFilter('sections', (html) =>
    [...html.matchAll(/<h2 id="([^"]+)"[^>]*>([\s\S]*?)<\/h2>/g)].map(([, id, title]) => ({
      id,
      title: title.replaceAll(/<[^>]+>/g, ''),
    })),
  );

  config.on('eleventy.after', () => pictures.draw());

  return {
    markdownTemplateEngine: false,
    dir: { includes: '../../tools/docs' },
  };
}
