// What the reader's program is given: a world made of a scene file and its pictures.
//
//     const world = makeWorld(scene, images);   // images: { [file]: { width, height, data } }
//
// README.md has the shapes. Imports nothing: it runs in a page, in a worker and under Node.

const kGrid = 65536; // coordinates are whole multiples of 1 / kGrid
const kSides = ['north', 'east', 'south', 'west'];
const kOpposite = { north: 'south', east: 'west', south: 'north', west: 'east' };
const kAcross = { north: [0, -1], east: [1, 0], south: [0, 1], west: [-1, 0] };

const rounded = (value) => Math.floor(kGrid * value + 0.5) / kGrid;

// The picture files that a scene names.
export function filesOf(scene) {
  const files = [
    ...Object.values(scene.textures),
    ...Object.values(scene.sprites ?? {}),
    ...scene.maps.map(({ sky }) => sky?.panorama).filter((file) => file !== undefined),
  ].map((texture) => texture.file ?? texture);
  return [...new Set(files)].filter((file) => !file.startsWith('#'));
}

// An eye, rounded as the engine does. `view` has x, y, z, heading and perhaps map and look.
export function makeEye(world, view, fov = 60) {
  const { map = Object.keys(world.maps)[0], x, y, z, heading = 0, look = 0 } = view;
  return { map, x: rounded(x), y: rounded(y), z: rounded(z), heading, look, fov };
}

export function makePicture(width, height) {
  return { width, height, pixels: new Uint8ClampedArray(4 * width * height) };
}

export function makeWorld(scene, images) {
  const leftOut = new Set();
  const textures = mapValues(scene.textures, (texture, name) =>
    readTexture(name, texture, images, leftOut),
  );
  const sprites = mapValues(scene.sprites ?? {}, (sprite, name) =>
    readTexture(name, sprite, images, leftOut),
  );
  const blueprints = mapValues(scene.blueprints ?? {}, (blueprint, name) =>
    readBlock(name, blueprint, textures, scene.motions ?? {}, leftOut),
  );
  const maps = {};
  for (const map of scene.maps)
    maps[map.name] = readMap(map, { scene, textures, sprites, blueprints, leftOut });
  for (const map of scene.maps) readPortals(map, maps, leftOut);
  return {
    maps,
    textures: { ...textures, ...sprites },
    seconds: 0,
    body: null,
    portalLimit: scene.portalLimit ?? 8,
    leftOut: [...leftOut],
  };
}

function mapValues(object, make) {
  return Object.fromEntries(Object.entries(object).map(([key, value]) => [key, make(value, key)]));
}

// "#rrggbb" as [red, green, blue, 255].
function readColour(text) {
  const channels = [1, 3, 5].map((at) => Number.parseInt(text.slice(at, at + 2), 16));
  return [...channels, 255];
}

// ---- textures

function readTexture(name, texture, images, leftOut) {
  if (typeof texture === 'string' && texture.startsWith('#')) return plainTexture(name, texture);
  const file = texture.file ?? texture;
  const image = images[file];
  if (!image) throw new Error(`makeWorld: the picture ${file} is missing`);
  if (texture.rate) leftOut.add(`the texture ${name} moves`);
  const levels = [firstFrame(image, texture.frames ?? 1)];
  for (let last = levels[0]; last.width % 2 === 0 && last.height % 2 === 0;) {
    last = halved(last);
    levels.push(last);
  }
  return { name, height: levels[0].height, seeThrough: hasHoles(levels[0].texels), levels };
}

function plainTexture(name, text) {
  const colour = readColour(text);
  const levels = [64, 32, 16, 8, 4, 2, 1].map((size) => {
    const texels = new Uint8ClampedArray(4 * size * size);
    for (let start = 0; start < texels.length; start += 4) texels.set(colour, start);
    return { width: size, height: size, texels };
  });
  return { name, height: 64, seeThrough: false, levels };
}

function hasHoles(texels) {
  for (let start = 3; start < texels.length; start += 4) if (texels[start] < 255) return true;
  return false;
}

function firstFrame({ width, height, data }, frames) {
  const frameWidth = width / frames;
  const texels = new Uint8ClampedArray(4 * frameWidth * height);
  for (let row = 0; row < height; row++) {
    const start = 4 * row * width;
    texels.set(data.subarray(start, start + 4 * frameWidth), 4 * row * frameWidth);
  }
  return { width: frameWidth, height, texels };
}

// The next level of detail: each texel is the mean of 2 x 2, weighted by alpha, in integers.
function halved({ width, height, texels }) {
  const half = { width: width / 2, height: height / 2 };
  half.texels = new Uint8ClampedArray(4 * half.width * half.height);
  for (let row = 0; row < half.height; row++) {
    for (let column = 0; column < half.width; column++) {
      const upper = 4 * (2 * row * width + 2 * column);
      const lower = upper + 4 * width;
      const mean = meanOf(texels, [upper, upper + 4, lower, lower + 4]);
      half.texels.set(mean, 4 * (row * half.width + column));
    }
  }
  return half;
}

function meanOf(texels, starts) {
  const sum = [0, 0, 0, 0];
  for (const start of starts) {
    const alpha = texels[start + 3];
    for (let channel = 0; channel < 3; channel++) sum[channel] += texels[start + channel] * alpha;
    sum[3] += alpha;
  }
  const alpha = sum[3];
  if (alpha === 0) return [0, 0, 0, 0];
  const mean = sum.map((total) => Math.floor((total + Math.floor(alpha / 2)) / alpha));
  mean[3] = Math.floor((alpha + 2) / 4);
  return mean;
}

// ---- blocks

function readFace(face, textures, leftOut) {
  const {
    texture,
    light = 1,
    mirror = 0,
    glow = false,
  } = typeof face === 'string' ? { texture: face } : face;
  if (glow) leftOut.add('what glows');
  return { texture: textures[texture], light, mirror: Math.floor(255 * mirror + 0.5) };
}

function readBlock(name, blueprint, textures, motions, leftOut) {
  const given = typeof blueprint.faces === 'string' ? { all: blueprint.faces } : blueprint.faces;
  const faces = {};
  for (const face of [...kSides, 'top', 'bottom']) {
    const isSide = kSides.includes(face);
    const found = given[face] ?? (isSide ? given.sides : undefined) ?? given.all;
    if (!found) continue;
    faces[face] = readFace(found, textures, leftOut);
    if (face !== 'top') faces[face].mirror = 0;
  }
  if (blueprint.water) leftOut.add('water');
  if (blueprint.gate) leftOut.add('gates that open by themselves');
  const bottom = rounded(blueprint.bottom ?? 0);
  const top = rounded(blueprint.top ?? 1);
  const block = {
    name,
    bottom,
    top,
    faces,
    seeThrough: Object.values(faces).some(({ texture }) => texture.seeThrough),
    join: blueprint.join ?? true,
  };
  if (blueprint.motion) {
    const { moves, from = 0, to, period, phase = 0, shape = 'smooth' } = motions[blueprint.motion];
    block.motion = { moves, from, to, period, phase, shape, bottom, top };
    block.moved = 0; // units, by `moveBlocks`
  }
  return block;
}

// ---- maps

function readMap(map, given) {
  const { scene, textures, sprites, blueprints, leftOut } = given;
  const size = map.levels.find((level) => level.length > 0);
  const depth = size.length;
  const width = [...size[0]].length;
  const empty = Array.from({ length: depth }, () => '.'.repeat(width));
  const levels = map.levels.map((level) => {
    const rows = level.length > 0 ? level : empty;
    return rows.map((row) => [...row]);
  });
  // Each map has blocks of its own, because they move; characters of one blueprint share a block.
  const own = mapValues(blueprints, (block) => ({ ...block }));
  const blocks = mapValues({ ...scene.legend, ...map.legend }, (name) => own[name]);
  if (map.sow) leftOut.add('sown objects');
  return {
    name: map.name,
    width,
    depth,
    levels,
    blocks,
    floor: readPlane(map.floor, textures, leftOut, 'own'),
    ceiling: map.ceiling ? readPlane(map.ceiling, textures, leftOut, 'none') : () => null,
    ceilingHeight: rounded(map.ceiling?.height ?? 0),
    sky: readSky(map.sky ?? '#96bee6', leftOut),
    light: {
      on: true,
      intensity: 1.5,
      multiplier: 5,
      darkest: 0.1,
      brightest: 1,
      ...map.light,
    },
    fog: map.fog ? { on: true, start: 0, ...map.fog } : { on: false, start: 0, end: 1 },
    haze: readColour(map.haze ?? '#96a0aa'),
    far: map.far ?? 10000,
    objects: (map.objects ?? []).map((object) => readObject(object, sprites, leftOut)),
    portals: [],
  };
}

// What a floor or a ceiling shows at a tile. Outside, a floor repeats its own texture.
function readPlane(plane, textures, leftOut, space) {
  const {
    texture,
    legend = {},
    tiles,
    ...rest
  } = typeof plane === 'string' ? { texture: plane } : plane;
  const lookOf = (name) => readFace({ ...rest, texture: name }, textures, leftOut);
  const own = lookOf(texture);
  const looks = mapValues(legend, lookOf);
  const outside = space === 'own' ? own : null;
  const rows = tiles?.map((row) =>
    [...row].map((character) => {
      if (character === '.') return own;
      return character === ' ' ? outside : looks[character];
    }),
  );
  return (x, y) => {
    if (rows) return rows[y]?.[x] ?? outside;
    return own;
  };
}

function readSky(sky, leftOut) {
  if (typeof sky === 'string') return { low: readColour(sky), high: readColour(sky), slope: 1 };
  if (sky.panorama) {
    leftOut.add('a sky with a panorama');
    return readSky('#96bee6', leftOut);
  }
  return { low: readColour(sky.low), high: readColour(sky.high), slope: sky.slope ?? 1 };
}

function readObject(object, sprites, leftOut) {
  const texture = sprites[object.sprite];
  const { width, height } = texture.levels[0];
  if (object.motion) leftOut.add('objects that move');
  if (object.glow) leftOut.add('what glows');
  return {
    texture,
    x: rounded(object.x),
    y: rounded(object.y),
    z: rounded(object.z ?? 0),
    width: rounded(object.width ?? (rounded(object.height) * width) / height),
    height: rounded(object.height),
    light: object.light ?? 1,
  };
}

// ---- portals

function readPortals(map, maps, leftOut) {
  for (const portal of map.portals ?? []) {
    if (!kSides.includes(portal.face)) {
      leftOut.add('portals that are not sides of blocks');
      continue;
    }
    const { x, y, level = 0, face } = portal;
    const turn = (portal.turn ?? 0) / 90;
    const to = { map: map.name, level, ...portal.to };
    maps[map.name].portals.push({ x, y, level, face, to, turn });
    if (portal.twoWay)
      maps[to.map].portals.push(wayBack(map.name, { x, y, level, face, to, turn }));
  }
}

// A face of the block behind the exit tile, which leads to the tile before the portal.
function wayBack(name, { x, y, level, face, to, turn }) {
  const exitFace = kSides[(kSides.indexOf(face) + turn) % 4];
  const [exitX, exitY] = kAcross[exitFace];
  const [aheadX, aheadY] = kAcross[face];
  return {
    x: to.x + exitX,
    y: to.y + exitY,
    level: to.level,
    face: kOpposite[exitFace],
    to: { map: name, x: x + aheadX, y: y + aheadY, level },
    turn: (4 - turn) % 4,
  };
}
