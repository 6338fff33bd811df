// What a kind of block looks like in its cell, and how to change it: heights and faces.
// Takes and gives blueprints as the scene has them. Changes nothing in place.
//
//     extentOf(blueprint)                       // {low, high, west, north, east, south}: 0 to 1
//     textureOf(blueprint, 'top')               // a texture's name, or null
//     waterOf(blueprint)                        // the colour in water, or null
//     withFace(blueprint, 'top', 'moss')        // the same with another texture there
//     withHeight(blueprint, 'top', 0.5)

export const kFaces = ['north', 'east', 'south', 'west', 'top', 'bottom'];
const kWater = '#265c68'; // as the engine has it
const kSides = ['north', 'east', 'south', 'west'];

export function extentOf({ bottom = 0, top = 1, plan = [0, 0, 1, 1] } = {}) {
  const [west, north, east, south] = plan;
  return {
    low: Math.min(...[bottom].flat()),
    high: Math.max(...[top].flat()),
    west,
    north,
    east,
    south,
  };
}

export function faceOf({ faces = {} }, face) {
  if (typeof faces === 'string') return faces;
  return faces[face] ?? (kSides.includes(face) ? faces.sides : undefined) ?? faces.all ?? null;
}

export function textureOf(blueprint, face) {
  const found = faceOf(blueprint, face);
  return typeof found === 'string' ? found : (found?.texture ?? null);
}

export function waterOf({ water }) {
  return water ? (water.colour ?? kWater) : null;
}

// Light, glow and the like of that face stay.
export function withFace(blueprint, face, texture) {
  const { faces = {} } = blueprint;
  const all = typeof faces === 'string' ? { all: faces } : faces;
  const present = faceOf(blueprint, face);
  const changed =
    typeof present === 'object' && present !== null ? { ...present, texture } : texture;
  const next = { ...all, [face]: changed };
  const names = kFaces.map((name) => faceOf({ faces: next }, name));
  const isOne = names.every((name) => typeof name === 'string' && name === names[0]);
  return { ...blueprint, faces: isOne && next.diagonal === undefined ? names[0] : next };
}

export function withAllFaces(blueprint, texture) {
  return { ...blueprint, faces: texture };
}

// The edge of a level block; null if it would have no height left.
export function withHeight(blueprint, edge, height) {
  const { bottom = 0, top = 1 } = blueprint;
  if (Array.isArray(bottom) || Array.isArray(top)) return null;
  const next = { bottom, top, [edge]: Math.round(height * 100) / 100 };
  if (!(next.bottom >= 0 && next.top <= 1 && next.bottom < next.top)) return null;
  const changed = { ...blueprint, ...next };
  if (next.bottom === 0) delete changed.bottom;
  if (next.top === 1) delete changed.top;
  return changed;
}

// "rock", "rock up to 0.5", "rock from 0.25 to 0.5": names that follow heights.
export function nameWithHeights(name, { bottom = 0, top = 1 }) {
  const stem = name.replace(/ (up to|from) [\d.]+( to [\d.]+)?( \d+)?$/, '');
  if (bottom === 0) return top === 1 ? stem : `${stem} up to ${top}`;
  return top === 1 ? `${stem} from ${bottom}` : `${stem} from ${bottom} to ${top}`;
}
