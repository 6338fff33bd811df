// Recordings: those that come with the page, and those that people make.

import { fetchBytes } from './fetch-bytes.js';
import { Trouble } from './trouble.js';

// The bytes of one of the page's recordings. Throws a Trouble.
export async function readTour(name) {
  if (!/^[\w-]+$/.test(name)) throw new Trouble('The address names no such tour', `Found tour=${name}, expected the name of one, as tour=castle.`);
  const address = new URL(`tours/${name}.txt`, document.baseURI);
  return fetchBytes(address).catch((error) => {
    throw new Trouble('The tour could not be loaded', `${address.href}: ${error.message}.`, [], 'tour');
  });
}

// Hands a text to the browser as a file to keep.
export function saveText(name, text) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], { type: 'text/plain' }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
