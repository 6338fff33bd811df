// Baked light in a world of boxes, as "Baked light" in web/docs/picture.md defines it: samples,
// light rays, nodes. Numbers are whole ones, in 1/65536 of a unit, and channels lists [r, g, b].
//
//     const light = new Light(boxesOf(scene), scene.maps[0].baked, { squares: 2, linked: true });
//     light.at(face, 0.25, 0.75);           // 0 to 256 each, at a point of a face
//
// A face is { box, side }, with box null for the floor: then x and y are its tile. `squares` and
// `linked` make the light coarser, finer, or leak.

export const kUnit = 65536;
const kLift = 16; // of samples off their face
const kNudge = [2 ** -10, 2 ** -20, 2 ** -30]; // east, less south, still less up: decides ties
const kCorners = [
  [0, 0],
  [1, 0],
  [0, 1],
  [1, 1],
];
const kTurns = [
  [0, 3],
  [1, 2],
];
// src/render/light/light_fans.h: rays to the sky, along a face's axes and outward.
export const kSkyWays = [
  [49152, 0, 190365],
  [-62775, 57507, 177220],
  [9609, -109486, 163019],
  [79124, 103203, 147456],
  [-145202, -25684, 130044],
  [137548, -87497, 109907],
  [-46007, 171144, 85134],
  [-87741, -168939, 49152],
];

const kSides = {
  west: { normal: 0, sign: -1, a: 1, b: 2 },
  east: { normal: 0, sign: 1, a: 1, b: 2 },
  north: { normal: 1, sign: -1, a: 0, b: 2 },
  south: { normal: 1, sign: 1, a: 0, b: 2 },
  bottom: { normal: 2, sign: -1, a: 0, b: 1 },
  top: { normal: 2, sign: 1, a: 0, b: 1 },
};

const colourOf = (text) => [1, 3, 5].map((at) => Number.parseInt(text.slice(at, at + 2), 16));
const raw = (value) => Math.floor(value * kUnit + 0.5);

// The blocks of a scene's first map. Slopes, halves and what moves are not expected.
export function boxesOf(scene) {
  const [map] = scene.maps;
  const legend = { ...scene.legend, ...map.legend };
  return map.levels.flatMap((rows, level) =>
    rows.flatMap((row, y) =>
      [...row].flatMap((sign, x) => {
        const blueprint = scene.blueprints[legend[sign]];
        if (blueprint === undefined) return [];
        const { bottom = 0, top = 1, plan = [0, 0, 1, 1] } = blueprint;
        const [west, north, east, south] = plan;
        return {
          sign,
          cell: [x, y, level],
          low: [x + west, y + north, level + bottom].map(raw),
          high: [x + east, y + south, level + top].map(raw),
        };
      }),
    ),
  );
}

// Light above 255 keeps its colour: the largest channel becomes 255, the others in proportion.
export function held(light) {
  const most = Math.max(...light);
  if (most <= 255) return light;
  return light.map((c) => Math.floor((c * 255 + Math.floor(most / 2)) / most));
}

export class Light {
  #boxes;
  #cells = new Map();
  #squares;
  #linked;
  #areas = new Map();
  #quarters = new Map();

  constructor(boxes, baked, { squares = 2, linked = true, width, depth }) {
    this.#boxes = boxes;
    for (const box of boxes) this.#cells.set(box.cell.join(), box);
    this.#squares = squares;
    this.#linked = linked;
    Object.assign(this, { width, depth });
    const { azimuth, altitude, colour } = baked.sun;
    const [turn, height] = [azimuth, altitude].map((angle) => (angle * Math.PI) / 180);
    this.sun = [
      Math.cos(height) * Math.cos(turn),
      Math.cos(height) * Math.sin(turn),
      Math.sin(height),
    ].map(raw);
    this.sunColour = colourOf(colour);
    this.ambient = colourOf(baked.ambient);
    this.lamps = (baked.lamps ?? []).map((lamp) => ({
      at: [lamp.x, lamp.y, lamp.z].map(raw),
      colour: colourOf(lamp.colour),
      strength: lamp.strength,
      radius: raw(lamp.radius),
    }));
  }

  // How far along `way` a ray meets something, as a share of it; Infinity if it is free. `end` is
  // where it ends: 1, or Infinity for the sun.
  meets(from, way, end = 1) {
    const at = from.map((value, axis) => value + kNudge[axis]);
    let first = way[2] < 0 ? at[2] / -way[2] : Infinity; // the floor
    for (const { low, high } of this.#boxes) {
      let enter = -Infinity;
      let leave = Infinity;
      for (let axis = 0; axis < 3; ++axis) {
        if (way[axis] === 0) {
          if (at[axis] < low[axis] || at[axis] > high[axis]) leave = -Infinity;
          continue;
        }
        const one = (low[axis] - at[axis]) / way[axis];
        const other = (high[axis] - at[axis]) / way[axis];
        enter = Math.max(enter, Math.min(one, other));
        leave = Math.min(leave, Math.max(one, other));
      }
      if (enter < leave && leave > 0 && enter < first) first = Math.max(0, enter);
    }
    return first < end ? first : Infinity;
  }

  // Whether it is in a block, or below the floor.
  isInside(point) {
    return (
      point[2] < 0 ||
      this.#boxes.some(({ low, high }) =>
        point.every((value, axis) => low[axis] <= value && value < high[axis]),
      )
    );
  }

  // Where a face lies.
  areaOf(face) {
    const { box, side, x, y } = face;
    if (box !== null) {
      if (!this.#areas.has(box)) this.#areas.set(box, {});
      return (this.#areas.get(box)[side] ??= this.#findArea(face));
    }
    const tile = this.width * y + x;
    if (!this.#areas.has(tile)) this.#areas.set(tile, this.#findArea(face));
    return this.#areas.get(tile);
  }

  #findArea({ box, side, x, y }) {
    if (box === null) {
      const tile = [x * kUnit, y * kUnit];
      return { ...kSides.top, plane: 0, tile, low: tile, high: tile.map((at) => at + kUnit) };
    }
    const area = { ...kSides[side] };
    const { a, b, normal, sign } = area;
    area.plane = (sign > 0 ? box.high : box.low)[normal];
    area.tile = [box.cell[a] * kUnit, box.cell[b] * kUnit];
    area.low = [box.low[a], box.low[b]];
    area.high = [box.high[a], box.high[b]];
    return area;
  }

  // Of the floor outside the grid.
  get outside() {
    const n = Math.floor((256 * this.sun[2]) / Math.hypot(...this.sun) + 0.5);
    const sum = this.sunColour.map(
      (c, i) => Math.floor((c * n * 255 + 32640) / 65280) + this.ambient[i],
    );
    return held(sum).map((c) => c + (c >> 7));
  }

  // ---- a sample's light

  // {sun, sky, lamps, sum}, with the rays that were asked; `turns` turns the rays to the sky.
  sample(point, area, turns) {
    const parts = { sun: this.#sunAt(point, area), sky: this.#skyAt(point, area, turns) };
    parts.lamps = this.lamps.map((lamp) => this.#lampAt(point, area, lamp));
    const all = [parts.sun, parts.sky, ...parts.lamps];
    parts.sum = [0, 1, 2].map((c) => all.reduce((sum, { light }) => sum + light[c], 0));
    return parts;
  }

  #sunAt(point, { normal, sign }) {
    const cosine = (sign * this.sun[normal]) / Math.hypot(...this.sun);
    const n = Math.floor(256 * Math.max(0, cosine) + 0.5);
    const meets = this.meets(point, this.sun, Infinity);
    const through = n > 0 && meets === Infinity ? 255 : 0;
    const light = this.sunColour.map((c) => Math.floor((c * n * through + 32640) / 65280));
    return { n, way: this.sun, meets, light };
  }

  #skyAt(point, { normal, sign, a, b }, turns) {
    const rays = kSkyWays.map(([alongA, alongB, outward]) => {
      let [p, q] = [alongA, alongB];
      for (let i = 0; i < turns; ++i) [p, q] = [-q, p];
      const way = [0, 0, 0];
      way[a] = p;
      way[b] = q;
      way[normal] = sign * outward;
      return { way, meets: this.meets(point, way) };
    });
    const free = rays.filter(({ meets }) => meets === Infinity).length;
    const light = this.ambient.map((c) => Math.floor((c * (1020 + 255 * free) + 1530) / 3060));
    return { rays, free, light };
  }

  #lampAt(point, { normal, sign }, { at, colour, strength, radius }) {
    const way = at.map((value, axis) => value - point[axis]);
    const square = way.reduce((sum, value) => sum + value * value, 0);
    const cosine = (sign * way[normal]) / Math.sqrt(square);
    const isNear = square < radius * radius && cosine > 0;
    const meets = isNear ? this.meets(point, way) : 0;
    const through = isNear && meets === Infinity ? 255 : 0;
    const w = 1 - square / (radius * radius);
    const light = colour.map((c) => {
      if (!isNear) return 0;
      const full = Math.floor((strength * c * w * w * (1 + 3 * cosine)) / 4 + 0.5);
      return Math.floor((full * through + 127) / 255);
    });
    return { way, isNear, meets, light };
  }

  // ---- quarters and nodes

  // A quarter of a face, in a column and a row; those beyond its ends belong to the face beside it.
  // Null if there is none, or if it does not count.
  quarter(face, area, column, row) {
    const count = 2 * this.#squares;
    const steps = [column, row].map((at) => (at < 0 ? -1 : at >= count ? 1 : 0));
    const at = this.#beside(face, area, steps);
    if (at === null) return null;
    const places = [column - count * steps[0], row - count * steps[1]];
    const own = at === face ? area : this.areaOf(at);
    if (own.plane !== area.plane) return null;
    const key = `${nameOf(at)} ${places.join(' ')}`;
    if (!this.#quarters.has(key)) this.#quarters.set(key, this.#makeQuarter(own, places));
    return this.#quarters.get(key);
  }

  #beside(face, area, [stepA, stepB]) {
    if (stepA === 0 && stepB === 0) return face;
    const cell = face.box === null ? [face.x, face.y, 0] : [...face.box.cell];
    cell[area.a] += stepA;
    cell[area.b] += stepB;
    if (face.box !== null) {
      const box = this.#cells.get(cell.join());
      return box === undefined ? null : { box, side: face.side };
    }
    const [x, y] = cell;
    const isWithin = x >= 0 && y >= 0 && x < this.width && y < this.depth;
    return isWithin ? { box: null, x, y } : null;
  }

  #makeQuarter(area, places) {
    const size = kUnit / this.#squares;
    const point = [0, 0, 0];
    for (const i of [0, 1]) {
      const begin = area.tile[i] + Math.floor(places[i] / 2) * size;
      const low = Math.max(area.low[i], begin);
      const high = Math.min(area.high[i], begin + size);
      if (low >= high) return null;
      const share = places[i] % 2 === 0 ? 1 : 3;
      point[i === 0 ? area.a : area.b] = low + Math.floor(((high - low) * share) / 4);
    }
    point[area.normal] = area.plane + area.sign * kLift;
    if (this.isInside(point)) return null;
    const turns = kTurns[places[0] % 2][places[1] % 2];
    return { point, turns, light: this.sample(point, area, turns).sum };
  }

  // The node of a square at one of its corners: the mean of the quarters round it that are linked
  // to the square's own.
  node(face, area, square, corner) {
    return this.#squareOf(face, area, square)[corner[0] + 2 * corner[1]];
  }

  // A square's four nodes: low low, high low, low high, high high.
  #squareOf(face, area, [squareA, squareB]) {
    const squares = (area.squares ??= []);
    const index = squareA + this.#squares * squareB;
    return (squares[index] ??= kCorners.map((corner) =>
      this.#makeNode(face, area, [squareA, squareB], corner),
    ));
  }

  #makeNode(face, area, [squareA, squareB], [cornerA, cornerB]) {
    const column = 2 * (squareA + cornerA) - 1;
    const row = 2 * (squareB + cornerB) - 1;
    const places = [
      [column, row],
      [column + 1, row],
      [column + 1, row + 1],
      [column, row + 1],
    ];
    const own = cornerB === 1 ? 1 - cornerA : 2 + cornerA;
    const round = places.map(([c, r]) => this.quarter(face, area, c, r));
    const linked = this.#linkedTo(round, own);
    const all = (first, count) =>
      Array.from({ length: count * count }, (_, i) =>
        this.quarter(face, area, first[0] + (i % count), first[1] + Math.floor(i / count)),
      ).filter((quarter) => quarter !== null);
    const found = [
      () => linked.map((index) => round[index]),
      () => all([2 * squareA, 2 * squareB], 2),
      () => all([0, 0], 2 * this.#squares),
    ].reduce((list, next) => (list.length > 0 ? list : next()), []);
    // The part of the ambient light that is everywhere
    if (found.length === 0) return this.ambient.map((c) => Math.floor((c * 1020 + 1530) / 3060));
    const mean = [0, 1, 2].map((c) => {
      const sum = found.reduce((total, { light }) => total + light[c], 0);
      return Math.floor((sum + Math.floor(found.length / 2)) / found.length);
    });
    return held(mean);
  }

  // Which of four quarters are linked to one of them, directly or through others.
  #linkedTo(round, own) {
    if (round[own] === null) return [];
    const linked = new Set([own]);
    const isFree = (i, j) => {
      if (round[i] === null || round[j] === null) return false;
      if (!this.#linked) return true;
      const [from, to] = [Math.min(i, j), Math.max(i, j)].map((index) => round[index].point);
      // The western, northern or lower one first
      const isTurned = from.some((value, axis) => value > to[axis]);
      const [first, second] = isTurned ? [to, from] : [from, to];
      return (
        this.meets(
          first,
          second.map((value, axis) => value - first[axis]),
        ) === Infinity
      );
    };
    for (const turn of [1, 3])
      for (let at = own, steps = 0; steps < 3; ++steps) {
        const next = (at + turn) % 4;
        if (!isFree(at, next)) break;
        linked.add(next);
        at = next;
      }
    return [...linked].sort();
  }

  // ---- a point

  // The light at a place of a face's tile, each from 0 to 65535: 0 to 256 for each channel.
  at(face, placeA, placeB) {
    const { nodes, weights } = this.between(face, placeA, placeB);
    const [w0, w1, w2, w3] = weights;
    const [n0, n1, n2, n3] = nodes;
    return n0.map((_, c) => {
      const light = (n0[c] * w0 + n1[c] * w1 + n2[c] * w2 + n3[c] * w3 + 8192) >> 14;
      return light + (light >> 7);
    });
  }

  // The four nodes of a place's square and their weights, of 16384: low low, high low, low high,
  // high high. `share` is the way from the lower nodes to the higher ones, of 128.
  between(face, placeA, placeB) {
    const size = kUnit / this.#squares;
    const square = [Math.floor(placeA / size), Math.floor(placeB / size)];
    const east = Math.floor(((placeA - square[0] * size) * 128) / size);
    const south = Math.floor(((placeB - square[1] * size) * 128) / size);
    const [west, north] = [128 - east, 128 - south];
    return {
      share: [east, south],
      nodes: this.#squareOf(face, this.areaOf(face), square),
      weights: [west * north, east * north, west * south, east * south],
    };
  }
}

const nameOf = ({ box, side, x, y }) =>
  box === null ? `floor ${x} ${y}` : `${side} ${box.cell.join(' ')}`;
