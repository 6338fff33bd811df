// Writes a world as a list of numbers, for raycaster.cpp: world.h reads them in the same order.

const kFaces = ['north', 'east', 'south', 'west', 'top', 'bottom'];
const kMoves = ['nothing', 'top', 'bottom', 'both'];
const kShapes = ['smooth', 'even', 'stop-and-go'];
const kStill = { moves: 'nothing', from: 0, to: 0, period: 1, phase: 0, shape: 'even' };

// `views` are [{ eye, width, height }]: the pictures to draw.
export function worldNumbers(world, views) {
  const textures = Object.values(world.textures);
  const maps = Object.values(world.maps);
  const list = (things, write) => [things.length, ...things.flatMap(write)];
  const textureOf = (texture) => textures.indexOf(texture);
  const lookOf = (look) => (look ? [textureOf(look.texture), look.light, look.mirror] : [-1, 1, 0]);
  const mapOf = (name) => Object.keys(world.maps).indexOf(name);

  const levelOf = ({ width, height, texels }) => {
    const colours = Array.from({ length: width * height }, (_, i) =>
      texels.subarray(4 * i, 4 * i + 4),
    );
    return [width, height, ...list(colours, (colour) => [...colour])];
  };
  const motionOf = ({ moves, from, to, period, phase, shape }, bottom, top) => [
    ...[kMoves.indexOf(moves), from, to, period, phase],
    ...[kShapes.indexOf(shape), bottom, top],
  ];
  const blockOf = (block) => {
    const { bottom, top } = block.motion ?? block;
    return [
      ...[bottom, top, Number(block.seeThrough), Number(block.join)],
      ...kFaces.flatMap((face) => lookOf(block.faces[face])),
      ...motionOf(block.motion ?? kStill, bottom, top),
    ];
  };
  const objectOf = ({ texture, x, y, z, width, height, light }) => [
    textureOf(texture),
    ...[x, y, z, width, height, light],
  ];
  const portalOf = ({ x, y, level, face, to, turn }) => [
    ...[x, y, level, kFaces.indexOf(face)],
    ...[mapOf(to.map), to.x, to.y, to.level, turn],
  ];
  const mapNumbers = (map) => {
    const { light, fog, sky } = map;
    const blocks = [...new Set(Object.values(map.blocks))];
    const cells = map.levels.flat(2).map((cell) => blocks.indexOf(map.blocks[cell]));
    const tiles = Array.from({ length: map.width * map.depth }, (_, i) => [
      i % map.width,
      Math.floor(i / map.width),
    ]);
    return [
      ...[map.width, map.depth, map.levels.length],
      ...list(blocks, blockOf),
      ...list(cells, (cell) => cell),
      ...list(tiles, ([x, y]) => lookOf(map.floor(x, y))),
      ...list(tiles, ([x, y]) => lookOf(map.ceiling(x, y))),
      ...lookOf(map.floor(-1, -1)),
      ...[map.ceilingHeight, map.far, sky.slope],
      ...[...map.haze, ...sky.low, ...sky.high],
      ...[Number(light.on), light.intensity, light.multiplier, light.darkest, light.brightest],
      ...[Number(fog.on), fog.start, fog.end],
      ...list(map.objects, objectOf),
      ...list(map.portals, portalOf),
    ];
  };
  const viewOf = ({ eye, width, height }) => {
    const { map, x, y, z, heading, look, fov } = eye;
    return [width, height, mapOf(map), x, y, z, heading, look, fov];
  };
  return Float64Array.from([
    ...list(textures, ({ levels }) => list(levels, levelOf)),
    ...list(maps, mapNumbers),
    ...[world.seconds, world.portalLimit],
    ...views.flatMap(viewOf),
  ]);
}
