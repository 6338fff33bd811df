// Writes a view as a link to this page, and as a tag or frame for another page.
//
//     const shared = sharedParameters({reference: 'castle.json', view, options: engine.options});
//     linkTo(shared, base);
//     tagFor(shared, {base, scene, label});
//     frameFor(shared, {base, label});

import { formatOptions, formatView, kOverlays, writeQuery } from '../engine/address.js';

// {scene, view, options, overlay} as an address spells them, null for standard values. Without a
// `view`, the scene's start.
export function sharedParameters({ reference, view = null, options }) {
  const changed = options.filter(({ value, standard }) => value !== standard);
  const overlays = changed.filter(({ name }) => kOverlays.includes(name)).map(({ name }) => name);
  const others = changed
    .filter(({ name }) => !kOverlays.includes(name))
    .map(({ name, value }) => [name, value]);
  return {
    scene: reference.replace(/\.json$/i, ''),
    view: view === null ? null : formatView(view),
    options: others.length === 0 ? null : formatOptions(others),
    overlay: overlays.length === 0 ? null : overlays.join(' '),
  };
}

// `base` is the page's folder.
export function linkTo(shared, base) {
  return new URL(writeQuery(shared), base).href;
}

// `scene` is the full address of the scene file, because another page is in another folder.
export function tagFor({ view, options, overlay }, { base, scene, label }) {
  const tag = openingTag('ray-caster', { scene, view, options, overlay, label, controls: '' });
  return `${openingTag('script', { type: 'module', src: new URL('ray-caster.js', base).href })}</script>\n${tag}</ray-caster>`;
}

export function frameFor(shared, { base, label }) {
  const source = new URL(`embed.html${writeQuery(shared)}`, base).href;
  return `${openingTag('iframe', { src: source, title: label, width: '640', height: '400', loading: 'lazy', allow: 'fullscreen' })}</iframe>`;
}

function openingTag(name, attributes) {
  const written = Object.entries(attributes)
    .filter(([, value]) => value !== null)
    .map(([key, value]) => (value === '' ? ` ${key}` : ` ${key}="${escape(value)}"`));
  return `<${name}${written.join('')}>`;
}

function escape(text) {
  return text.replace(/&/g, '&amp;').replace(/"/g, '&quot;').replace(/</g, '&lt;');
}
