// Finds the world to edit: of a link, a template, a shipped scene, or what was kept here before.
// Takes an address; gives the text and where its pictures are. Changes nothing.
//
//     const world = await openWorld(new URL(location.href));
//     {name, text, isStranger}                // `name`: under which it is kept
//     readPicture(own, file)                  // the bytes of a picture of the scene, or null
//
// edit.html?scene=castle, ?template=cave, ?file=mine (see open-dialog.js), #world=... (a
// stranger's), or nothing. With &tour the first steps are shown again.

import { fetchBytes } from '../engine/fetch-bytes.js';
import { kHome } from '../engine/home.js';
import { Autosave } from './files/autosave.js';
import { templates } from './files/templates.js';
import { isWorldLink, textOf } from './files/world-link.js';
import { printed } from './json-text.js';

const kScenes = new URL('scenes/', kHome);
const kName = /^[\w-]+$/;

export async function openWorld(address) {
  const wanted = address.searchParams;
  if (isWorldLink(address.hash)) {
    const text = textOf(address.hash);
    return { name: `link ${hashOf(address.hash)}`, text, isStranger: true };
  }
  const scene = wanted.get('scene');
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
    const text = (await new Autosave(`file ${file}`).read())?.text;
    if (text === undefined)
      throw new Error(`This browser has no world "${file}". Open its file again.`);
    return { name: `file ${file}`, text, isStranger: false };
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

// Each link has a name of its own, so that what was made of one is there again.
function hashOf(text) {
  let [one, other] = [0x811c9dc5, 0x1b873593];
  for (let at = 0; at < text.length; ++at) {
    one = Math.imul(one ^ text.charCodeAt(at), 0x01000193);
    other = Math.imul(other ^ text.charCodeAt(at), 0x5bd1e995);
  }
  return [one, other].map((part) => (part >>> 0).toString(16)).join('');
}

// Pictures of the world itself come first; then the shipped ones, and no others.
export function readPicture(own, file) {
  const mine = own.get(file);
  if (mine !== undefined) return Promise.resolve(mine);
  if (!/^\.\.\/(textures|see-through|sheets|sprites)\/[\w-]+\.png$/.test(file))
    return Promise.resolve(null);
  return fetchBytes(new URL(file, kScenes));
}
