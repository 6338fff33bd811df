// A world in a link: the scene's text, packed, behind the sign # of an address. No server sees it.
// Takes texts; gives links and texts. Bounds what a stranger's link can unpack to.
//
//     linkOf(text, base)             // an address, or null if the world is too large for one
//     link.length > kSureCharacters  // mails and chats may cut it
//     textOf(hash)                   // '#world=...' -> its text; throws an Error in plain words

import { deflateSync, Inflate, strFromU8, strToU8 } from 'fflate';

export const kSureCharacters = 8000;
const kMostCharacters = 32000; // of the link: browsers take longer ones, but do not show them
const kMostBytes = 4 << 20; // of the text that a link unpacks to
const kStart = '#world=';

export function linkOf(text, base) {
  const packed = deflateSync(strToU8(small(text)), { level: 9, mem: 12 });
  const letters = btoa(strFromU8(packed, true))
    .replaceAll('+', '-')
    .replaceAll('/', '_')
    .replaceAll('=', '');
  const link = new URL(`${kStart}${letters}`, base).href;
  return link.length > kMostCharacters ? null : link;
}

// Without the space between its parts. JSON.stringify would do more: it puts keys that are numbers
// first, and the palette has the order of the legend.
function small(text) {
  return text.replaceAll(/("(?:[^"\\]|\\.)*")|\s+/g, (_, quoted) => quoted ?? '');
}

export function isWorldLink(hash) {
  return hash.startsWith(kStart);
}

export function textOf(hash) {
  let packed = null;
  try {
    packed = strToU8(
      atob(hash.slice(kStart.length).replaceAll('-', '+').replaceAll('_', '/')),
      true,
    );
  } catch {
    throw new Error('The link is damaged: a part of it is missing. Copy it whole.');
  }
  const parts = [];
  let size = 0;
  const inflate = new Inflate((part) => {
    size += part.length;
    if (size > kMostBytes)
      throw new Error('The world in the link is too large: found more than 4 MB, expected less.');
    parts.push(part);
  });
  try {
    // In pieces, so that it stops soon after the limit.
    for (let at = 0; at < packed.length; at += 1024)
      inflate.push(packed.subarray(at, at + 1024), at + 1024 >= packed.length);
  } catch (error) {
    if (size > kMostBytes) throw error;
    throw new Error('The link is damaged: a part of it is missing. Copy it whole.', {
      cause: error,
    });
  }
  const bytes = new Uint8Array(size);
  let at = 0;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return new TextDecoder().decode(bytes);
}
