// Colours code when the pages are built, by the parsers of the editor and with its classes (tok-*).
//
//     colour(text, 'js', (line) => line === 3)      // HTML; line 3 is marked as new

import { parser as cpp } from '@lezer/cpp';
import { classHighlighter, highlightCode } from '@lezer/highlight';
import { parser as javascript } from '@lezer/javascript';

const kParsers = { js: javascript, javascript, cpp, 'c++': cpp };

const escape = (text) =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');

export function colour(code, language, isNew = () => false) {
  const text = code.replace(/\n$/, '');
  const parser = kParsers[language];
  if (parser === undefined) return `${escape(text)}\n`;
  const lines = [''];
  highlightCode(
    text,
    parser.parse(text),
    classHighlighter,
    (part, classes) => {
      lines[lines.length - 1] +=
        classes === '' ? escape(part) : `<span class="${classes}">${escape(part)}</span>`;
    },
    () => lines.push(''),
  );
  return lines
    .map((line, index) => (isNew(index) ? `<mark class="new">${line}</mark>\n` : `${line}\n`))
    .join('');
}
