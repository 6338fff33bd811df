// How the scenes of a folder use pictures.

import { readFileSync, readdirSync } from 'node:fs';

// A map by the pictures' names, 'sprites/cat.png', with
//
//     named      where a scene gives it a name: [{scene, frames, views, rate}]
//     heights    the heights of its objects in all scenes, in units, the smallest first
export function usesInScenes(folder) {
  const uses = new Map();
  const usesOf = (entry) => {
    const name = (entry.file ?? entry).replace(/^\.\.\//, '');
    if (!uses.has(name)) uses.set(name, { named: [], heights: [] });
    return uses.get(name);
  };
  const files = readdirSync(folder).filter((name) => name.endsWith('.json'));
  const add = (scene) => {
    const { textures, sprites, maps } = JSON.parse(readFileSync(`${folder}/${scene}`, 'utf8'));
    const named = [textures, sprites].flatMap((each) => Object.values(each ?? {}));
    for (const entry of named) {
      const { frames = 1, views = 1, rate } = entry;
      usesOf(entry).named.push({ scene, frames, views, rate });
    }
    const objects = maps.flatMap((map) => [...(map.objects ?? []), ...(map.sow ?? [])]);
    for (const { sprite, height } of objects)
      usesOf(sprites[sprite]).heights.push(...[height].flat());
  };
  for (const scene of files.sort().filter((name) => name !== 'index.json')) {
    try {
      add(scene);
    } catch {
      // It has faults, which the page tells.
    }
  }
  for (const { heights } of uses.values()) heights.sort((left, right) => left - right);
  return uses;
}
