// Which addresses of scenes, tours and posters a link or a frame's address may name: those of the
// page's own origin, and those that the page's owner allows besides, by what they begin with. Whoever
// writes such a link is not the owner. What the attributes of an element name is its author's own
// affair.
//
//     <meta name="slicecast-scenes" content="https://worlds.example/ https://cdn.example/maps/">      or * for all
//
//     allowed(new URL(scene, document.baseURI))       the same address; throws a Trouble

import { Trouble } from './trouble.js';

export function allowed(address) {
  const told = document.querySelector('meta[name=slicecast-scenes]')?.content ?? '';
  const isOwn =
    address.origin === location.origin && /^(https?|file|blob):$/.test(address.protocol);
  const beginnings = told.split(/\s+/).filter(Boolean);
  if (isOwn || beginnings.some((one) => one === '*' || begins(address, one))) return address;
  throw new Trouble(
    'This page shows nothing from elsewhere',
    `Found ${address.href.slice(0, 200)}, expected an address that begins with ${[`${location.origin}/`, ...beginnings].join(' or ')}. The page's owner can allow more, by a meta tag with the name slicecast-scenes.`,
    [],
    'address',
  );
}

// Whole parts of the address: https://a.example is not the beginning of https://a.example.org.
function begins(address, beginning) {
  try {
    const { href } = new URL(beginning);
    return address.href === href || address.href.startsWith(href.replace(/\/?$/, '/'));
  } catch {
    return false;
  }
}
