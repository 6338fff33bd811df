// Pictures whose light is not the scene's: drawn by the reader's program, in a world whose map has
// another light, fog or haze. Chapter 14 is the first that draws all levels of blocks.

import { draw } from '../by-hand/chapter-14.js';
import { drawWith } from '../by-hand.js';

// A side of a divider. `change(state)` gives fields of the map: { light, fog, haze, sky }.
export function drawnIn(change, fov = 66) {
  const drawn = drawWith(draw, { fov });
  return (picture, world, eye, state) => {
    const map = world.maps[eye.map];
    const { light, fog, ...others } = change(state);
    const changed = {
      ...map,
      ...others,
      light: { ...map.light, ...light },
      fog: { ...map.fog, ...fog },
    };
    drawn(picture, { ...world, maps: { ...world.maps, [eye.map]: changed } }, eye, state);
  };
}

export const limit = (value, least, greatest) => Math.min(greatest, Math.max(least, value));
