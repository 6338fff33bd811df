// Which scenes, tours and posters a link or a frame's address may name: those of the page's own
// origin, and those that start with a prefix that the page's owner allows. The author of a link is
// not the page's owner. Attributes of an element are not checked: its author chose them.
//
//     <meta name="slicecast-scenes" content="https://worlds.example/ https://cdn.example/maps/">
//                                                     or * to allow everything
//
//     allowed(new URL(scene, document.baseURI))       returns the address, or throws a Trouble

import { Trouble } from './trouble.js';

export function allowed(address) {
  const prefixes = document.querySelector('meta[name=slicecast-scenes]')?.content ?? '';
  const isOwn =
    address.origin === location.origin && /^(https?|file|blob):$/.test(address.protocol);
  const beginnings = prefixes.split(/\s+/).filter(Boolean);
  if (isOwn || beginnings.some((one) => one === '*' || begins(address, one))) return address;
  throw new Trouble(
    'This page does not allow that address',
    `Found ${address.href.slice(0, 200)}, expected an address that begins with ${[`${location.origin}/`, ...beginnings].join(' or ')}. The page's owner can allow more with a meta tag named slicecast-scenes.`,
    [],
    'address',
  );
}

// Compares whole parts: https://a.example does not match https://a.example.org.
function begins(address, beginning) {
  try {
    const { href } = new URL(beginning);
    return address.href === href || address.href.startsWith(href.replace(/\/?$/, '/'));
  } catch {
    return false;
  }
}
