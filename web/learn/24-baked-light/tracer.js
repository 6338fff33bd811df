// Draws a world of boxes pixel by pixel, with a light of one's choice: a small tracer, to compare
// ways to light.

import { distanceOf, rayOf } from '../figures/kit.js';
import { boxesOf, held, kUnit, Light } from './light.js';

const kSideAxis = { north: 0, south: 0, west: 1, east: 1 };

// What drawWorld is given: of a scene, and of the world that makeWorld made of it. `lightOf` keeps
// each light that was asked for.
export function litWorld(world, scene) {
  const map = world.maps[scene.maps[0].name];
  const boxes = boxesOf(scene);
  const lights = new Map();
  return {
    map,
    boxes,
    lightOf({ squares = 2, linked = true } = {}) {
      const key = `${squares} ${linked}`;
      if (!lights.has(key)) {
        const { width, depth } = map;
        const [{ baked }] = scene.maps;
        lights.set(key, new Light(boxes, baked, { squares, linked, width, depth }));
      }
      return lights.get(key);
    },
  };
}

// `lit(face, place, pointOf)` gives the light of a texel: its place in the tile along the face's
// two axes, and the point that the pixel's ray met, as a graphics card has it, with 24 bits.
export function drawWorld(picture, { map, boxes }, eye, fov, lit) {
  const { width, height, data } = picture;
  const distance = distanceOf(fov, width);
  const horizon = height / 2 + eye.look * height;
  for (let column = 0; column < width; ++column) {
    const ray = rayOf(eye, column, [width, height], fov);
    const met = boxes
      .map((box) => ({ box, ...passage(box, eye, ray) }))
      .filter(({ near, far }) => near < far && far > 0)
      .sort((left, right) => left.near - right.near);
    for (let row = 0; row < height; ++row) {
      const slope = (horizon - (row + 0.5)) / distance;
      const at = 4 * (row * width + column);
      data.set(colourOf(nearest(met, eye, slope), { map, eye, ray, slope, lit }), at);
      data[at + 3] = 255;
    }
  }
}

// The stretch of a ray over a box, seen from above, and the side that it enters.
function passage({ low, high }, eye, ray) {
  const spans = [
    [eye.x, 'west', 'east'],
    [eye.y, 'north', 'south'],
  ].map(([from, lower, upper], axis) => {
    const ends = [low[axis], high[axis]].map((edge) => (edge / kUnit - from) / ray[axis]);
    return { near: Math.min(...ends), far: Math.max(...ends), side: ray[axis] > 0 ? lower : upper };
  });
  const last = spans[0].near > spans[1].near ? spans[0] : spans[1];
  return { near: last.near, far: Math.min(spans[0].far, spans[1].far), side: last.side };
}

// {depth, box, side} of the nearest thing; box null: the floor; null: the sky. `met` is in the
// order of its nearer ends.
function nearest(met, eye, slope) {
  let depth = slope < 0 ? eye.z / -slope : Infinity;
  let found = null;
  let isFlat = false;
  for (const each of met) {
    if (each.near > depth) break;
    const { box } = each;
    const low = (box.low[2] / kUnit - eye.z) / slope;
    const high = (box.high[2] / kUnit - eye.z) / slope;
    const flat = Math.min(low, high);
    const enter = Math.max(each.near, flat);
    if (enter >= Math.min(each.far, Math.max(low, high)) || enter <= 0 || enter >= depth) continue;
    depth = enter;
    found = each;
    isFlat = flat > each.near;
  }
  if (found === null) return slope < 0 ? { depth, box: null, side: 'top' } : null;
  return { depth, box: found.box, side: isFlat ? (slope < 0 ? 'top' : 'bottom') : found.side };
}

function colourOf(thing, { map, eye, ray, slope, lit }) {
  if (thing === null) {
    const share = Math.min(1, slope / map.sky.slope);
    const { low, high } = map.sky;
    return [0, 1, 2].map((c) => Math.floor(low[c] + (high[c] - low[c]) * share + 0.5));
  }
  const { depth, box, side } = thing;
  const ways = [ray[0], ray[1], slope];
  const from = [eye.x, eye.y, eye.z];
  const point = ways.map((way, axis) => from[axis] + depth * way);
  const isFlat = side === 'top' || side === 'bottom';
  const axes = isFlat ? [0, 1] : [kSideAxis[side], 2];
  const tile = box === null ? [Math.floor(point[0]), Math.floor(point[1])] : box.cell;
  const look = box === null ? map.floor(...tile) : map.blocks[box.sign].faces[side];
  const { width, texels } = look.texture.levels[0];
  // The texel along the face's axes, and where the picture has it
  const index = axes.map((axis) =>
    Math.min(width - 1, Math.max(0, Math.floor((point[axis] - tile[axis]) * width))),
  );
  const u = side === 'north' || side === 'east' ? width - 1 - index[0] : index[0];
  const v = isFlat && side !== 'bottom' ? index[1] : width - 1 - index[1];
  const at = 4 * (v * width + u);
  const place = index.map((i) => Math.floor(((2 * i + 1) * 32768) / width));
  const face = box === null ? { box: null, x: tile[0], y: tile[1] } : { box, side };
  const light = lit(face, place, () =>
    ways.map((way, axis) => {
      const walked = Math.fround(Math.fround(depth) * Math.fround(way));
      return Math.fround(Math.fround(from[axis]) + walked);
    }),
  );
  const q = Math.min(256, Math.floor(256 * look.light + 0.5));
  return [0, 1, 2].map((c) => (((texels[at + c] * light[c] + 128) >> 8) * q + 128) >> 8);
}

// Light between the nodes of each face.
export const byNodes =
  (light, { width, depth }) =>
  (face, [a, b]) => {
    if (face.box === null && (face.x < 0 || face.y < 0 || face.x >= width || face.y >= depth))
      return light.outside;
    return light.at(face, a, b);
  };

// Each pixel asks the sun itself, from the point that its ray met, lifted off the face by so many
// units.
export const bySunRays = (light, lift) => (face, place, pointOf) => {
  const { normal, sign } = light.areaOf(face);
  const at = pointOf().map(
    (value, axis) => kUnit * Math.fround(value + (axis === normal ? sign * lift : 0)),
  );
  const share = Math.max(0, (sign * light.sun[normal]) / Math.hypot(...light.sun));
  const isFree = at[2] >= 0 && light.meets(at, light.sun, Infinity) === Infinity;
  const sum = light.sunColour.map((c, i) =>
    Math.floor(light.ambient[i] + (isFree ? c * share : 0) + 0.5),
  );
  return held(sum).map((c) => c + (c >> 7));
};
