// Finds the world to edit: of a link, a template, a shipped scene, or what was kept here before.
// Takes an address; gives the text and where its pictures are. Changes nothing.
//
//     const world = await openWorld(new URL(location.href));
//     {name, text, isStranger}                // `name`: under which it is kept
//     {home, form, tag, isRead}               // if it has a file: see saving.js; `isRead`: now
//     isVisit(address)                        // an old link: nobody has asked to edit
//     readPicture(own, file, world)           // the bytes of a picture of the scene, or null
//
// edit.html?scene=castle, ?scene=-/scene/mine.json (that of tools/play), ?template=cave, ?file=mine
// (see world-store.js), ?copy#world=... (a stranger's), or nothing. With &tour the first steps are
// shown again.

import { fetchBytes } from '../engine/fetch-bytes.js';
import { kHome } from '../engine/home.js';
import { placesOf, readFirst } from '../engine/source-parts.js';
import { pickedFile, servedFile } from './files/file-homes.js';
import { templates } from './files/templates.js';
import { textIn } from './files/text-form.js';
import { isWorldLink, textOf } from './files/world-link.js';
import { readWorld } from './files/world-store.js';
import { printed } from './json-text.js';

const kScenes = new URL('scenes/', kHome);
const kName = /^[\w-]+$/;
const kServed = /^-\/scene\/[^/\\]+$/;

export const isVisit = (address) => isWorldLink(address.hash) && !address.searchParams.has('copy');

export async function openWorld(address) {
  const wanted = address.searchParams;
  if (isWorldLink(address.hash)) {
    const text = textOf(address.hash);
    return { name: `link ${hashOf(address.hash)}`, text, isStranger: true };
  }
  const scene = wanted.get('scene');
  if (scene !== null && kServed.test(scene)) {
    const at = `-/scene/${encodeURIComponent(scene.slice('-/scene/'.length))}`;
    return ofFile(await servedFile(at));
  }
  if (scene !== null) {
    if (!kName.test(scene))
      throw new Error(
        `scene: found "${scene}", expected the name of a shipped scene, such as castle`,
      );
    const bytes = await fetchBytes(new URL(`${scene}.json`, kScenes));
    return { name: scene, text: new TextDecoder().decode(bytes), isStranger: false };
  }
  const file = wanted.get('file');
  if (file !== null) {
    const kept = await readWorld(`file ${file}`);
    if (kept === null) throw new Error(`This browser has no world "${file}". Open its file again.`);
    const { text, base = {} } = kept;
    const home = base.handle === undefined ? null : pickedFile(base.handle);
    const now = (await home?.ifReadable()) ?? null;
    const { form, tag } = base;
    return {
      ...{ name: `file ${file}`, text, isStranger: false, home, form, tag },
      ...(now === null ? {} : { ...textIn(now.bytes), tag: now.tag, isRead: true }),
    };
  }
  const name = wanted.get('template') ?? templates[0].name;
  const template = templates.find((one) => one.name === name);
  if (template === undefined)
    throw new Error(
      `template: found "${name}", expected ${templates.map((one) => one.name).join(', ')}`,
    );
  return {
    name: `template ${name}`,
    text: `${printed(template.scene(), '')}\n`,
    isStranger: false,
  };
}

async function ofFile(home) {
  const { bytes, tag } = await home.read();
  return {
    name: `served ${home.id}`,
    isStranger: false,
    home,
    tag,
    isRead: true,
    ...textIn(bytes),
  };
}

// Each link has a name of its own, so that what was made of one is there again.
function hashOf(text) {
  let [one, other] = [0x811c9dc5, 0x1b873593];
  for (let at = 0; at < text.length; ++at) {
    one = Math.imul(one ^ text.charCodeAt(at), 0x01000193);
    other = Math.imul(other ^ text.charCodeAt(at), 0x5bd1e995);
  }
  return [one, other].map((part) => (part >>> 0).toString(16)).join('');
}

// Whatever the scene names, only the server of tools/play is asked.
function besideServed(file, scene) {
  const address = new URL(file, scene);
  return address.href.startsWith(new URL('../', scene).href) ? address : null;
}

// Pictures of the world itself come first; then those beside its file, if tools/play serves them;
// then the shipped ones, and no others.
export async function readPicture(own, file, { home } = {}) {
  const mine = own.get(file);
  if (mine !== undefined) return mine;
  const beside = home?.at === undefined ? null : besideServed(file, home.at);
  const places = placesOf(file, beside, kHome);
  return places.length === 0 ? null : readFirst(places, fetchBytes);
}
