// Eleventy's configuration for the tutorial: a page of web/learn/NN-NAME/index.md is built as
// NAME.html, with one layout (chapter.njk) and relative links, so that the folder works anywhere.

import { readFileSync } from 'node:fs';

import { chapterMap } from './map.mjs';
import { markdown, unlistedNumbers } from './markdown.mjs';
import { panelHtml } from './write-panel.mjs';

const kVersion = /project\(Slicecast VERSION ([0-9.]+)/;
const kKeys = ['title', 'question', 'minutes', 'needs', 'new', 'write'];

export function configure(config, { chapters, program, formulas }) {
  const chapterOf = ({ page }) =>
    chapters.get(/\d\d-([a-z-]+)\/index\.md$/.exec(page.inputPath)?.[1]) ?? null;
  const parser = markdown(chapterOf, program, formulas);

  config.setLibrary('md', checked(parser));
  config.setIncludesDirectory('../../tools/learn');
  config.setTemplateFormats(['md']);
  config.ignores.add('web/learn/**/README.md');
  config.addGlobalData('templateEngineOverride', 'md'); // {{ }} is a number of a figure
  config.addGlobalData('layout', 'chapter.njk');
  config.addGlobalData(
    'permalink',
    () =>
      ({ page }) =>
        `${page.inputPath.replace(/^.*?(?:\d\d-)?([a-z-]+)\/index\.md$/, '$1').replace('learn', 'index')}.html`,
  );
  config.addGlobalData('version', kVersion.exec(readFileSync('CMakeLists.txt', 'utf8'))[1]);
  config.addGlobalData('eleventyComputed', { chapter: (data) => chapterOf(data) });

  // The pages of the chapters, in their order.
  config.addCollection('chapters', (all) => {
    const pages = all.getAll().filter((page) => chapterOf(page.data) !== null);
    for (const page of pages) {
      for (const key of kKeys)
        if (page.data[key] === undefined)
          throw new Error(`${page.inputPath}: its front matter has no "${key}".`);
      for (const name of page.data.needs)
        if (!chapters.has(name))
          throw new Error(
            `${page.inputPath}: it needs the chapter "${name}", which does not exist.`,
          );
    }
    return pages.sort((left, right) => chapterOf(left.data).number - chapterOf(right.data).number);
  });

  // The panel of the reader's raycaster, below a chapter; none if its `write` is false.
  config.addAsyncFilter('panel', async ({ chapter, write }) => {
    if (write === false) return '';
    const options = Object.entries(write.options ?? {}).map(([name, value]) => `${name}=${value}`);
    return panelHtml({
      chapter: chapter.number,
      scene: `scenes/${write.scene}`,
      view: write.view,
      options: options.join(' '),
    });
  });
  config.addFilter('sections', (html) =>
    [...html.matchAll(/<h2 id="([^"]+)"[^>]*>([\s\S]*?)<\/h2>/g)].map(([, id, title]) => ({
      id,
      title: title.replaceAll(/<[^>]+>/g, ''),
    })),
  );
  config.addFilter('map', (pages) =>
    chapterMap(
      pages.map(({ data: { chapter, title, needs } }) => ({
        number: chapter.number,
        name: chapter.name,
        title,
        needs,
      })),
    ),
  );
  config.addFilter('inline', (text) => parser.renderInline(text ?? ''));

  // The parser, which refuses numbers without a source, and names the page in its errors.
  function checked(markdownIt) {
    return {
      render(text, data) {
        try {
          const tokens = markdownIt.parse(text, data);
          const unlisted = unlistedNumbers(tokens, data.facts);
          if (unlisted.length > 0)
            throw new Error(
              'these numbers are neither computed nor listed under "facts":\n' +
                unlisted.map(({ number, text: where }) => `  ${number} in "${where}"`).join('\n'),
            );
          const html = markdownIt.renderer.render(tokens, markdownIt.options, data);
          refuseEqualIds(html);
          return html;
        } catch (error) {
          throw new Error(`${data.page.inputPath}: ${error.message}`, { cause: error });
        }
      },
    };
  }
}

// A figure and a heading may not have the same name: a link would find only one of them.
function refuseEqualIds(html) {
  const ids = [...html.matchAll(/<(?:figure|section|h[23])\b[^>]* id="([^"]+)"/g)].map(
    ([, id]) => id,
  );
  const twice = ids.find((id, index) => ids.indexOf(id) !== index);
  if (twice !== undefined)
    throw new Error(`two headings or figures have the id "${twice}"; expected different names.`);
}
