// A small program that draws blocks with sloped tops, for views from outside of them: column by
// column, from far to near. It can make three mistakes.

import { distanceOf, rayOf } from '../figures/kit.js';
import { kFov } from './plane.js';

const kAcross = { north: 'x', south: 'x', west: 'y', east: 'y' };

// What the program is given: the blocks of a scene's first map, of the world that makeWorld made.
export function rampsOf(world, scene) {
  const map = world.maps[scene.maps[0].name];
  const blocks = [];
  for (let y = 0; y < map.depth; ++y)
    for (let x = 0; x < map.width; ++x) {
      const block = map.blocks[map.levels[0][y][x]];
      if (block === undefined) continue;
      const { rise = 'east', top = 1 } = scene.blueprints[block.name];
      const [low, high] = [top].flat();
      const isTurned = rise === 'west';
      blocks.push({
        x,
        y,
        faces: block.faces,
        west: isTurned ? (high ?? low) : low,
        rise: high === undefined ? 0 : isTurned ? low - high : high - low,
      });
    }
  return { map, blocks };
}

// #region row
// Where a ray meets the plane of a block's top: it is `above` the eye there where the eye is, and
// has a horizon of its own.
function planeOf(block, eye, ray, view) {
  return {
    above: block.west + block.rise * (eye.x - block.x) - eye.z,
    horizon: view.horizon - view.distance * block.rise * ray[0],
  };
}

function rowAt(plane, depth, view) {
  return plane.horizon - (view.distance * plane.above) / depth;
}
// #endregion

// `mistake`: null, 'flat', 'middle' or 'sign'.
export function drawRamps(picture, { map, blocks }, eye, mistake = null) {
  const { width, height } = picture;
  const view = { width, height, distance: distanceOf(kFov, width) };
  view.horizon = height / 2 + eye.look * height;
  const middle = rayOf(eye, (width - 1) / 2, [width, height], kFov);
  for (let column = 0; column < width; ++column) {
    const ray = rayOf(eye, column, [width, height], kFov);
    drawFar(picture, column, map, eye, ray, view);
    const met = blocks
      .map((block) => ({ block, ...crossing(block, eye, ray) }))
      .filter(({ near, far }) => near > 0 && near < far)
      .sort((left, right) => right.near - left.near);
    for (const each of met)
      drawBlock(
        picture,
        column,
        each,
        eye,
        { ray, aim: mistake === 'middle' ? middle : ray },
        view,
        mistake,
      );
  }
}

// Where the ray enters a tile and leaves it, and through which face it enters.
function crossing(block, eye, ray) {
  const spans = [
    [block.x, eye.x, ray[0], ['west', 'east']],
    [block.y, eye.y, ray[1], ['north', 'south']],
  ].map(([edge, from, way, faces]) => {
    const ends = [(edge - from) / way, (edge + 1 - from) / way];
    return { near: Math.min(...ends), far: Math.max(...ends), face: faces[way > 0 ? 0 : 1] };
  });
  const last = spans[0].near > spans[1].near ? spans[0] : spans[1];
  return { near: last.near, far: Math.min(spans[0].far, spans[1].far), face: last.face };
}

function drawBlock(picture, column, { block, near, far, face }, eye, { ray, aim }, view, mistake) {
  const isSloped = block.rise !== 0;
  const plane = planeOf(block, eye, isSloped ? aim : ray, view);
  if (isSloped && mistake === 'sign') plane.above = -plane.above;
  const [nearRow, farRow] = [near, far].map((depth) => rowAt(plane, depth, view));
  const shown = isSloped && mistake === 'flat' ? view.horizon : plane.horizon;
  const fillTop = (first, last) =>
    fill(picture, column, first, last, (row) => {
      const depth = Math.abs((view.distance * plane.above) / (shown - (row + 0.5)));
      return texelOf(block.faces.top, eye.x + depth * ray[0], eye.y + depth * ray[1]);
    });
  if (farRow < nearRow) fillTop(farRow, nearRow);
  else if (mistake === 'sign' && isSloped) fillTop(nearRow, farRow);

  const side = block.faces[face];
  const u = kAcross[face] === 'x' ? eye.x + near * ray[0] : eye.y + near * ray[1];
  const isReversed = face === 'north' || face === 'east';
  const foot = view.horizon + (view.distance * eye.z) / near;
  fill(picture, column, nearRow, foot, (row) => {
    const z = eye.z + ((view.horizon - (row + 0.5)) * near) / view.distance;
    return texelOf(side, isReversed ? -u : u, 1 - z);
  });
}

function drawFar(picture, column, map, eye, ray, view) {
  const { low, high, slope } = map.sky;
  const floor = map.floor(0, 0);
  fill(picture, column, 0, view.horizon, (row) => {
    const share = Math.min(1, (view.horizon - (row + 0.5)) / view.distance / slope);
    return [0, 1, 2].map((c) => Math.floor(low[c] + (high[c] - low[c]) * share + 0.5));
  });
  fill(picture, column, view.horizon, view.height, (row) => {
    const depth = (view.distance * eye.z) / (row + 0.5 - view.horizon);
    return texelOf(floor, eye.x + depth * ray[0], eye.y + depth * ray[1]);
  });
}

// Rows whose middles lie between two places.
function fill({ width, height, data }, column, from, to, colourOf) {
  const first = Math.max(0, Math.ceil(from - 0.5));
  const last = Math.min(height, Math.ceil(to - 0.5));
  for (let row = first; row < last; ++row) {
    const at = 4 * (row * width + column);
    data.set(colourOf(row), at);
    data[at + 3] = 255;
  }
}

function texelOf({ texture, light }, x, y) {
  const { width, height, texels } = texture.levels[0];
  const index = (value, size) => Math.min(size - 1, Math.floor((value - Math.floor(value)) * size));
  const at = 4 * (index(y, height) * width + index(x, width));
  const q = Math.min(256, Math.floor(256 * light + 0.5));
  return [0, 1, 2].map((c) => (texels[at + c] * q + 128) >> 8);
}
