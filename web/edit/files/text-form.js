// How a file holds its text: with or without a byte order mark, with which line ends. The document
// has neither, and a save puts them back, so that a file differs only where somebody changed it.
//
//     const { text, form } = textIn(bytes);        // throws an Error in plain words
//     const bytes = bytesIn(text, form);           // form: see kPlainForm
//
// A file that mixes line ends keeps them as they are.

export const kPlainForm = { hasMark: false, lineEnd: '\n' };

const kMark = '\uFEFF';

export function textIn(bytes) {
  let whole = '';
  try {
    whole = new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    throw new Error('Found bytes that are no UTF-8, expected a text.');
  }
  const hasMark = whole.startsWith(kMark);
  const text = hasMark ? whole.slice(1) : whole;
  const isCrlf = text.includes('\r\n') && !/\r(?!\n)|(?<!\r)\n/.test(text);
  return {
    text: isCrlf ? text.replaceAll('\r\n', '\n') : text,
    form: { hasMark, lineEnd: isCrlf ? '\r\n' : '\n' },
  };
}

export function bytesIn(text, { hasMark, lineEnd } = kPlainForm) {
  const lines = lineEnd === '\n' ? text : text.replaceAll(/\r?\n/g, lineEnd);
  return new TextEncoder().encode(hasMark ? kMark + lines : lines);
}
