// Recordings that come with the page.

import { fetchBytes } from '../engine/fetch-bytes.js';
import { Trouble } from '../engine/trouble.js';

// The bytes of one of the page's recordings. Throws a Trouble.
export async function readTour(name) {
  if (!/^[\w-]+$/.test(name))
    throw new Trouble(
      'The address names no such tour',
      `Found tour=${name}, expected the name of one, as tour=castle.`,
    );
  const address = new URL(`tours/${name}.txt`, document.baseURI);
  return fetchBytes(address).catch((error) => {
    throw new Trouble(
      'The tour could not be loaded',
      `${address.href}: ${error.message}.`,
      [],
      'tour',
    );
  });
}
