// Compares the reader's functions with the engine's trace. `expectations` runs in the page and
// returns plain data; `check` runs where the reader's functions are.

const kColumns = 9;
const kTolerance = 1e-6;
const kStep = 2e-5; // the engine rounds to 1/65,536 units
const kExact = 1e-9; // what is left of a division; sums with 32 bits drift by more

// What the engine says about some columns of the view on show: see README.md.
export function expectations(chapter, { size, trace, seconds = 0 }) {
  const last = size.width - 1;
  const columns = Array.from({ length: kColumns }, (_, i) =>
    Math.round((last * (i + 0.5)) / kColumns),
  );
  const slices = trace(columns);
  const [{ map, eye, fov, horizonRow, projectionDistance }] = slices;
  return {
    size,
    seconds,
    eye: { ...eye, map, fov },
    horizon: horizonRow,
    distance: projectionDistance,
    columns: slices.map(readSlice),
  };
}

function readSlice(slice) {
  const plain = (list, fields) =>
    list.map((each) => Object.fromEntries(fields.map((field) => [field, each[field]])));
  return {
    column: slice.column,
    ray: { x: slice.ray[0], y: slice.ray[1] },
    walk: plain(slice.walk, ['portals', 'tile', 'axis', 'depth', 'next']),
    hits: plain(slice.hits, [
      ...['portals', 'map', 'tile', 'level', 'blueprint', 'face', 'point', 'depth'],
      ...['bottom', 'top', 'topFrontRow', 'bottomFrontRow'],
    ]),
    runs: plain(slice.runs, [
      ...['what', 'map', 'portals', 'hit', 'face', 'texture', 'first', 'last', 'layer', 'texels'],
    ]),
    objects: plain(slice.objects, ['portals', 'depth', 'sprite']),
    portals: plain(slice.portals, ['portals', 'from', 'to', 'turn', 'levels']),
  };
}

// [{ name, ok, says }], one for each function that can be checked, in the order of the chapters.
export function check(chapter, functions, expected, world) {
  const done = [];
  for (const [name, { from, to = Infinity, run }] of Object.entries(kChecks)) {
    if (chapter < from || chapter > to) continue;
    done.push(runOne(name, run, { chapter, functions, expected, world }));
  }
  return done;
}

class Wrong extends Error {}

function runOne(label, run, given) {
  const name = label.split(' ')[0];
  const { functions, expected, world } = given;
  const says = (text) => ({ name, ok: false, says: `\`${name}\`${text}` });
  if (typeof functions[name] !== 'function') return says(' is not there.');
  const { eye } = expected;
  const map = world.maps[eye.map];
  try {
    run(functions[name], {
      ...given,
      eye,
      map,
      view: {
        width: expected.size.width,
        height: expected.size.height,
        distance: expected.distance,
        horizon: expected.horizon,
        up: 1,
        ...directions(eye.heading),
      },
    });
  } catch (error) {
    if (error instanceof Wrong) return says(error.message);
    return says(` stops with "${error?.message ?? error}".`);
  }
  return { name, ok: true, says: '' };
}

function directions(heading) {
  const angle = (heading * Math.PI) / 180;
  const forward = { x: Math.cos(angle), y: Math.sin(angle) };
  return { forward, right: { x: -forward.y, y: forward.x } };
}

// ---- saying what is wrong

const shown = (value) => {
  if (typeof value === 'number') return String(Math.round(value * 1e4) / 1e4);
  if (value === undefined || value === null) return 'nothing';
  if (typeof value === 'string') return value;
  return JSON.stringify(value, (_, part) =>
    typeof part === 'number' ? Number(shown(part)) : part,
  );
};

function tell(where, mine, engine) {
  throw new Wrong(`${where}: yours ${shown(mine)}, engine ${shown(engine)}`);
}

// Numbers count as equal if they differ by less than one part in a million.
function mustBe(where, mine, engine, tolerance = kTolerance) {
  if (typeof engine !== 'number') {
    if (mine !== engine) tell(where, mine, engine);
    return;
  }
  const limit = tolerance * Math.max(1, Math.abs(engine));
  const isSame = mine === engine || Math.abs(mine - engine) <= limit;
  if (typeof mine !== 'number' || !isSame) tell(where, mine, engine);
}

function mustBeColour(where, mine, engine, most = 0) {
  const isSame = [0, 1, 2].every((i) => Math.abs(mine?.[i] - engine[i]) <= most);
  if (!isSame) tell(where, mine && [...mine].slice(0, 3), [...engine].slice(0, 3));
}

// ---- what the engine met, before portals

const own = (list) => list.filter(({ portals }) => portals === 0);

function faceOf({ axis }, ray) {
  if (axis === 'x') return ray.x > 0 ? 'west' : 'east';
  return ray.y > 0 ? 'north' : 'south';
}

// The tiles of a column with their blocks from below.
function tilesOf({ walk, hits }) {
  const blocks = new Map();
  for (const hit of own(hits)) {
    const key = String(hit.tile);
    blocks.set(key, [...(blocks.get(key) ?? []), hit]);
  }
  return own(walk).map(({ tile, depth }) => {
    const found = blocks.get(String(tile)) ?? [];
    return { x: tile[0], y: tile[1], depth, blocks: found.sort((a, b) => a.level - b.level) };
  });
}

function eachTile({ expected, map }, visit) {
  for (const column of expected.columns) {
    for (const tile of tilesOf(column)) {
      if (tile.x < 0 || tile.y < 0 || tile.x >= map.width || tile.y >= map.depth) continue;
      visit(tile, column);
    }
  }
}

// A slice as the reader's draw makes it, with an empty picture.
function emptySlice({ expected, view, map, eye, world }, { column, ray }) {
  const { width, height } = expected.size;
  const pixels = new Uint8ClampedArray(4 * width * height);
  const words = new Uint32Array(pixels.buffer);
  const picture = { width, height, pixels, words };
  const open = new Uint8Array(height).fill(1);
  const part = { open, layers: [], first: 0, last: height, lowest: -Infinity, portals: 0 };
  return { ...part, picture, column, map, eye, view, ray, world };
}

// A slice of one column whose eye looks east at a wall, over a floor that mirrors.
function beforeAWall({ wall, sky, floor }) {
  const plain = (colour, mirror = 0) => {
    const texels = Uint8ClampedArray.from([...colour, 255]);
    return {
      texture: { name: '', height: 1, levels: [{ width: 1, height: 1, texels }] },
      light: 1,
      mirror,
    };
  };
  const sides = ['north', 'east', 'south', 'west', 'top', 'bottom'];
  const block = { name: 'wall', bottom: 0, top: 1, seeThrough: false, join: true };
  block.faces = Object.fromEntries(sides.map((side) => [side, plain(wall)]));
  const ground = plain(floor, 255);
  const map = {
    ...{ name: 'mirror', width: 3, depth: 1, levels: [[['.', '.', '#']]], blocks: { '#': block } },
    ...{ floor: () => ground, ceiling: () => null, ceilingHeight: 1 },
    ...{ sky: { low: [...sky, 255], high: [...sky, 255], slope: 1 }, haze: [128, 128, 128, 255] },
    light: { on: false, intensity: 1, multiplier: 1, darkest: 0, brightest: 1 },
    fog: { on: false, start: 50, end: 100 },
    ...{ far: 100, objects: [], portals: [] },
  };
  const size = { width: 1, height: 80 };
  const eye = { map: 'mirror', x: 0.5, y: 0.5, z: 0.5, heading: 0, look: 0, fov: 60 };
  const view = { ...size, distance: 40, horizon: 20, up: 1, ...directions(0) };
  const world = { maps: { mirror: map }, seconds: 0, portalLimit: 16, body: null };
  const given = { expected: { size }, view, map, eye, world };
  return emptySlice(given, { column: 0, ray: { x: 1, y: 0 } });
}

const bodyAt = (x, y, z = 0) => ({ x, y, z, halfWidth: 0.2, height: 0.72, step: 0.5 });

const fogged = (colour, haze, light, fog) =>
  [0, 1, 2].map((i) => {
    const lit = (colour[i] * light + 128) >> 8;
    return Math.floor((haze[i] * fog + lit * (255 - fog) + 127) / 255);
  });

// ---- the checks, by function; those of one function have its name and a word more

const kChecks = {
  isInside: {
    from: 1,
    run(isInside, { map }) {
      for (const [x, y, inside] of [
        [0, 0, true],
        [map.width - 1, map.depth - 1, true],
        [-1, 0, false],
        [0, -1, false],
        [map.width, 0, false],
        [0, map.depth, false],
      ])
        mustBe(`, tile ${x}, ${y}`, Boolean(isInside(map, x, y)), inside);
    },
  },
  blockAt: {
    from: 1,
    run(blockAt, given) {
      eachTile(given, ({ x, y, blocks }) => {
        const levels = given.chapter < 12 ? 1 : given.map.levels.length;
        for (let level = 0; level < levels; level++) {
          const hit = blocks.find((block) => block.level === level);
          const mine = blockAt(given.map, x, y, level);
          // Blocks that move may be on other levels than they were built on.
          if (mine?.motion || (hit && given.map.blocks && isMoving(given.map, hit))) continue;
          mustBe(`, tile ${x}, ${y}, level ${level}`, mine?.name, hit?.blueprint);
        }
      });
    },
  },
  makeView: {
    from: 1,
    run(makeView, { chapter, expected, eye }) {
      const view = makeView(expected.size, eye);
      mustBe(', `distance`', view?.distance, expected.distance);
      const horizon = chapter < 9 ? expected.size.height / 2 : expected.horizon;
      mustBe(', `horizon`', view.horizon, horizon);
      const { forward, right } = directions(eye.heading);
      mustBe(', `forward.x`', view.forward?.x, forward.x);
      mustBe(', `forward.y`', view.forward.y, forward.y);
      mustBe(', `right.x`', view.right?.x, right.x);
      mustBe(', `right.y`', view.right.y, right.y);
    },
  },
  rayOf: {
    from: 1,
    run(rayOf, { expected, view }) {
      for (const { column, ray } of expected.columns) {
        const mine = rayOf(view, column);
        mustBe(`, column ${column}, x`, mine?.x, ray.x);
        mustBe(`, column ${column}, y`, mine.y, ray.y);
      }
    },
  },
  march: {
    from: 2,
    to: 2,
    run(march, { expected, map, eye }) {
      for (const { column, ray, hits } of expected.columns) {
        const [hit] = own(hits);
        if (!hit) continue;
        // It may go too far by a step.
        mustBe(`, column ${column}`, march(map, eye, ray), hit.depth + 0.005, 0.006);
      }
    },
  },
  walkGrid: {
    from: 3,
    run(walkGrid, { chapter, expected, map, eye }) {
      for (const { column, ray, walk } of expected.columns) {
        const tiles = walkGrid(map, eye, ray);
        const known = own(walk);
        // Chapter 22 decides where a ray goes on that meets a corner.
        const corner = chapter < 22 ? known.findIndex(({ next }) => isTie(...next)) : -1;
        if (corner >= 0) known.length = corner + 1;
        known.forEach((step, index) => {
          const where = `, column ${column}, tile ${index} of the way`;
          const mine = tiles?.[index];
          mustBe(where, mine && `${mine.x}, ${mine.y}`, step.tile.join(', '));
          mustBe(`${where}, \`near\``, mine.near, step.depth, kExact);
          if (index > 0) mustBe(`${where}, \`face\``, mine.face, faceOf(step, ray));
          const next = known[index + 1];
          if (next) mustBe(`${where}, \`far\``, mine.far, next.depth, kExact);
        });
        const last = tiles.at(-1);
        const isOutside = last.x < 0 || last.y < 0 || last.x >= map.width || last.y >= map.depth;
        const where = `, column ${column}, the last of the list`;
        mustBe(where, isOutside ? 'outside the map' : 'inside the map', 'outside the map');
        mustBe(`${where}, \`far\``, last.far === Infinity ? 'endless' : shown(last.far), 'endless');
      }
    },
  },
  rowOf: {
    from: 4,
    run(rowOf, { expected, view, eye }) {
      for (const { column, hits } of expected.columns) {
        for (const { top, bottom, depth, topFrontRow, bottomFrontRow } of own(hits)) {
          if (topFrontRow === null || depth === 0) continue;
          const where = (height) => `, column ${column}, height ${height}, depth ${shown(depth)}`;
          mustBe(where(top), rowOf({ view, eye }, top, depth), topFrontRow);
          mustBe(where(bottom), rowOf({ view, eye }, bottom, depth), bottomFrontRow);
        }
      }
    },
  },
  slopeOf: {
    from: 4,
    run(slopeOf, { expected, view, eye }) {
      const { height } = expected.size;
      for (const row of [0, Math.floor(height / 2), height - 1]) {
        const slope = (expected.horizon - (row + 0.5)) / expected.distance;
        mustBe(`, row ${row}`, slopeOf({ view, eye }, row), slope);
      }
    },
  },
  fillRows: {
    from: 4,
    run(fillRows, given) {
      for (const column of given.expected.columns) {
        const run = column.runs.find(({ what, hit }) => what === 'side' && hit === 0);
        const [hit] = column.hits;
        if (!run || run.layer || hit.topFrontRow === null || hit.depth === 0) continue;
        if (!isWhole(run, hit, given.expected.size)) continue;
        const rows = [];
        fillRows(emptySlice(given, column), hit.topFrontRow, hit.bottomFrontRow, (row) => {
          rows.push(row);
          return [1, 2, 3, 255];
        });
        if (rows.length === 0) tell(`, column ${column.column}`, 'no row', `row ${run.first}`);
        mustBe(`, column ${column.column}, first row`, Math.min(...rows), run.first);
        mustBe(`, column ${column.column}, last row`, Math.max(...rows), run.last);
      }
    },
  },
  'fillRows once': {
    from: 13,
    run(fillRows, given) {
      const slice = emptySlice(given, given.expected.columns[0]);
      slice.open[2] = 0;
      const rows = [];
      fillRows(slice, 1, 4, (row) => {
        rows.push(row);
        return [1, 2, 3, 255];
      });
      mustBe(', rows 1 to 3, of which row 2 is closed', rows.join(' '), '1 3');
    },
  },
  put: {
    from: 4,
    run(put, given) {
      const { width } = given.expected.size;
      const slice = emptySlice(given, given.expected.columns[1]);
      put(slice, 3, [10, 20, 30, 255]);
      const start = 4 * (3 * width + slice.column);
      const pixel = slice.picture.pixels.subarray(start, start + 4);
      mustBe(`, column ${slice.column}, row 3`, [...pixel].join(' '), '10 20 30 255');
      if (given.chapter >= 13) mustBe(', `open` of a row that is filled', slice.open[3], 0);
    },
  },
  'put see-through': {
    from: 16,
    run(put, given) {
      const slice = emptySlice(given, given.expected.columns[1]);
      put(slice, 3, [10, 20, 30, 0]);
      mustBe(', layers after a hole', slice.layers.length, 0);
      mustBe(', `open` of a row behind a hole', slice.open[3], 1);
      put(slice, 3, [10, 20, 30, 100]);
      mustBe(', layers after a colour of alpha 100', slice.layers.length, 1);
      mustBe(', `open` of a row behind it', slice.open[3], 1);
    },
  },
  texelOf: {
    from: 6,
    run(texelOf, { expected, world }) {
      for (const { column, runs } of expected.columns) {
        for (const run of runs) {
          const texture = world.textures[run.texture];
          if (!texture) continue;
          for (const { row, depth, detail, size, u, v } of run.texels) {
            const level = texture.levels[detail];
            const start = 4 * (v * size[0] + u);
            const where = `, column ${column}, row ${row}, texel ${u}, ${v} of ${run.texture}`;
            const [across, down] = [(u + 0.5) / size[0], (v + 0.5) / size[1]];
            const mine = texelOf(texture, across, down, depth / expected.distance);
            const name = detail > 0 ? `${where}, level ${detail}` : where;
            mustBeColour(name, mine, level.texels.subarray(start, start + 4));
          }
        }
      }
    },
  },
  skyColour: {
    from: 9,
    run(skyColour, { map }) {
      const { low, high, slope } = map.sky;
      for (const rise of [0, 0.1 * slope, 0.5 * slope, 2 * slope]) {
        const share = Math.min(1, rise / slope);
        const sky = low.map((channel, i) =>
          Math.floor(channel + (high[i] - channel) * share + 0.5),
        );
        mustBeColour(`, slope ${shown(rise)}`, skyColour(map, rise), sky);
      }
    },
  },
  blend: {
    from: 10,
    run(blend) {
      for (const weight of [0, 100, 255]) {
        const [over, under] = [
          [200, 101, 3, 255],
          [0, 37, 255, 255],
        ];
        const mixed = over.map((channel, i) =>
          Math.floor((channel * weight + under[i] * (255 - weight) + 127) / 255),
        );
        mustBeColour(`, weight ${weight}`, blend(over, under, weight), mixed);
      }
    },
  },
  shade: {
    from: 10,
    run(shade, { expected, world }) {
      for (const { column, hits, runs } of expected.columns) {
        for (const run of runs) {
          if (run.what !== 'side' || !run.texels?.length) continue;
          const map = world.maps[run.map];
          const { blueprint } = hits[run.hit];
          const block = Object.values(map.blocks).find(({ name }) => name === blueprint);
          const { depth, light, fog } = run.texels[0];
          const mine = shade(map, [200, 150, 77, 255], depth, block.faces[run.face].light);
          const engine = fogged([200, 150, 77], map.haze, light, fog);
          mustBeColour(`, column ${column}, depth ${shown(depth)}`, mine, engine);
        }
      }
    },
  },
  'shade darkest': {
    from: 10,
    run(shade, { map }) {
      const clear = { ...map, fog: { ...map.fog, on: false } };
      const { darkest, brightest } = map.light;
      for (const [depth, light] of [
        [1e6, darkest],
        [1e-6, brightest],
      ]) {
        const mine = shade(clear, [200, 150, 77, 255], depth, 1);
        const factor = map.light.on ? Math.floor(256 * light + 0.5) : 256;
        mustBeColour(
          `, without fog, depth ${depth}`,
          mine,
          fogged([200, 150, 77], map.haze, factor, 0),
        );
      }
    },
  },
  groundUnder: {
    from: 11,
    run(groundUnder, given) {
      eachTile(given, ({ x, y, blocks }) => {
        if (blocks.some((hit) => isMoving(given.map, hit))) return;
        // What hangs higher than a body is tall does not touch it.
        const [z, height] = [0, 0.72];
        let ground = 0;
        for (const { bottom, top } of blocks)
          if (bottom < Math.max(z, ground) + height) ground = Math.max(ground, top);
        const mine = groundUnder(given.map, bodyAt(x + 0.5, y + 0.5));
        mustBe(`, the middle of tile ${x}, ${y}`, mine, ground);
      });
    },
  },
  move: {
    from: 11,
    run(move, given) {
      const found = wallAhead(given);
      if (!found) return;
      const { x, y, stepX, stepY } = found;
      const body = { ...bodyAt(x + 0.5, y + 0.5), map: given.eye.map };
      for (let i = 0; i < 40; i++) move(given.world, body, 0.02 * stepX, 0.02 * stepY);
      const gone = Math.abs(stepX ? body.x - x - 0.5 : body.y - y - 0.5);
      const where = `, from the middle of tile ${x}, ${y} against a wall, 0.8 units in small steps`;
      if (!(gone <= 0.3 + 1e-9)) tell(where, gone, 'at most 0.3');
      if (!(gone > 0.25)) tell(where, gone, 'more than 0.25');
      const slides = { ...bodyAt(x + 0.5, y + 0.5), map: given.eye.map };
      for (let i = 0; i < 40; i++)
        move(given.world, slides, 0.02 * stepX + 0.002 * stepY, 0.02 * stepY + 0.002 * stepX);
      const aside = Math.abs(stepX ? slides.y - y - 0.5 : slides.x - x - 0.5);
      mustBe(`${where}, 0.08 units along the wall`, aside, 0.08);
    },
  },
  blocksOf: {
    from: 12,
    run(blocksOf, given) {
      eachTile(given, ({ x, y, blocks }) => {
        if (blocks.some((hit) => isMoving(given.map, hit))) return;
        const list = (of) => of.map(({ bottom, top }) => `${shown(bottom)} to ${shown(top)}`);
        const mine = blocksOf(given.map, x, y);
        // Parts of movers that are elsewhere now
        const still = mine?.filter(({ block }) => !block.motion) ?? [];
        const told = (of) => list(of).join(', ') || 'no block';
        mustBe(`, tile ${x}, ${y}`, told(still), told(blocks));
      });
    },
  },
  planesOf: {
    from: 13,
    run(planesOf, given) {
      const { map, eye } = given;
      eachTile(given, ({ x, y, depth, blocks }, column) => {
        if (blocks.length === 0 || blocks.some((hit) => isMoving(map, hit))) return;
        const slice = emptySlice(given, column);
        const made = blocks.map(({ blueprint, level, bottom, top }) => ({
          block: Object.values(map.blocks).find(({ name }) => name === blueprint),
          ...{ level, bottom, top },
        }));
        const planes = planesOf(slice, { x, y, near: depth, far: depth + 1, blocks: made });
        const away = planes.map(({ height }) => Math.abs(height - eye.z));
        const where = `, tile ${x}, ${y}`;
        const sorted = [...away].sort((a, b) => a - b);
        mustBe(`${where}, distances from the eye's height`, shown(away), shown(sorted));
        for (const { top, bottom, blueprint } of blocks) {
          const block = Object.values(map.blocks).find(({ name }) => name === blueprint);
          if (block.seeThrough) continue;
          const heights = planes.map(({ height }) => height);
          // What nobody sees from this height may be left out.
          const seen = [0, top].filter((height) => height < eye.z);
          if (bottom > eye.z) seen.push(bottom);
          for (const height of seen)
            if (!heights.includes(height)) tell(`${where}, heights`, heights, height);
        }
      });
      // A block over the eye, whatever the view shows.
      const slice = emptySlice(given, given.expected.columns[0]);
      const block = Object.values(map.blocks).find((each) => !each.seeThrough);
      const high = { block, level: 1, bottom: 1, top: 2 };
      const low = { ...slice, eye: { ...eye, z: 0.5 } };
      const planes = planesOf(low, { x: 1, y: 1, near: 1, far: 2, blocks: [high] });
      const underside = planes.find(
        ({ height, look }) => height === 1 && look === block.faces.bottom,
      );
      if (!underside?.under)
        tell(', a block from 1 to 2, `under` of its underside', 'not true', 'true');
    },
  },
  objectsOf: {
    from: 15,
    run(objectsOf, given) {
      for (const column of given.expected.columns) {
        const mine = objectsOf(emptySlice(given, column));
        const depths = mine.map(({ depth }) => depth);
        const where = `, column ${column.column}, depths`;
        const sorted = [...depths].sort((a, b) => a - b);
        mustBe(where, shown(depths), shown(sorted));
        for (const { depth } of own(column.objects))
          if (!depths.some((each) => Math.abs(each - depth) < kStep)) tell(where, depths, depth);
      }
      // Three objects in a row, one of them behind the eye, whatever the view shows.
      const slice = emptySlice(given, given.expected.columns[0]);
      const at = (x) => ({ ...given.map.objects[0], x, y: 0, z: 0, width: 1, height: 1 });
      const row = objectsOf({
        ...slice,
        map: { ...given.map, objects: [at(5), at(-3), at(2)] },
        eye: { ...given.eye, x: 0, y: 0 },
        view: { ...slice.view, forward: { x: 1, y: 0 }, right: { x: 0, y: 1 } },
        ray: { x: 1, y: 0 },
      });
      const depths = row.map(({ depth }) => depth);
      const where =
        ', the eye looks east, objects 5 and 2 units to the east and 3 to the west, depths';
      mustBe(where, shown(depths), shown([2, 5]));
    },
  },
  isJoined: {
    from: 16,
    run(isJoined) {
      const pane = { seeThrough: true, join: true };
      const alike = { ...pane };
      const at = (block, level, top = level + 1) => ({ block, level, bottom: level, top });
      for (const [what, one, others, level, joined] of [
        ['two panes of one block', at(pane, 1), [at(pane, 1)], 1, true],
        ['a pane on another', at(pane, 0), [at(pane, 0), at(pane, 1)], 1, true],
        ['a pane above a gap', at(pane, 0, 0.5), [at(pane, 1)], 1, false],
        ['two panes on two levels', at(pane, 1), [at(pane, 0)], 1, false],
        ['panes of two blocks', at(pane, 1), [at(alike, 1)], 1, false],
        ['no neighbour', at(pane, 1), [], 1, false],
      ])
        mustBe(`, ${what}`, Boolean(isJoined(one, others, level)), joined);
      const wall = { seeThrough: false, join: true };
      const leaves = { seeThrough: true, join: false };
      for (const block of [wall, leaves]) {
        const what = block === wall ? 'two opaque blocks' : 'two blocks that do not join';
        mustBe(`, ${what}`, Boolean(isJoined(at(block, 0), [at(block, 0)], 0)), false);
      }
    },
  },
  layOver: {
    from: 16,
    run(layOver, given) {
      const slice = emptySlice(given, given.expected.columns[1]);
      const start = 4 * (5 * given.expected.size.width + slice.column);
      slice.picture.pixels.set([90, 80, 70, 255], start);
      slice.layers.push({ row: 5, colour: [250, 10, 0, 100] });
      slice.layers.push({ row: 5, colour: [0, 200, 40, 200] });
      layOver(slice);
      const mix = (over, under, weight) =>
        over.map((channel, i) =>
          Math.floor((channel * weight + under[i] * (255 - weight) + 127) / 255),
        );
      const engine = mix([250, 10, 0], mix([0, 200, 40], [90, 80, 70], 200), 100);
      const mine = slice.picture.pixels.subarray(start, start + 4);
      mustBeColour(', red of alpha 100 before green of alpha 200', mine, engine);
    },
  },
  moveBlocks: {
    from: 17,
    run(moveBlocks, given) {
      const { world, map, expected } = given;
      world.seconds = expected.seconds;
      moveBlocks(world);
      for (const block of Object.values(map.blocks)) {
        if (!block.motion) continue;
        for (const seconds of [0, 0.3, 0.5, 0.7].map((part) => part * block.motion.period)) {
          world.seconds = seconds;
          moveBlocks(world);
          const { moves, bottom, top } = block.motion;
          const moved = offsetOf(block.motion, seconds);
          const where = `, the block "${block.name}" after ${shown(seconds)} seconds`;
          mustBe(
            `${where}, \`bottom\``,
            block.bottom,
            bottom + (moves === 'top' ? 0 : moved),
            kStep,
          );
          mustBe(`${where}, \`top\``, block.top, top + (moves === 'bottom' ? 0 : moved), kStep);
        }
      }
      world.seconds = expected.seconds;
      moveBlocks(world);
    },
  },
  'moveBlocks body': {
    from: 17,
    run(moveBlocks, { world, map, eye, expected, functions }) {
      for (const block of Object.values(map.blocks)) {
        if (block.motion?.moves !== 'bottom') continue;
        const y = map.levels[0].findIndex((row) => row.some((cell) => map.blocks[cell] === block));
        if (y < 0) continue;
        const x = map.levels[0][y].findIndex((cell) => map.blocks[cell] === block);
        const body = { ...bodyAt(x + 0.5, y + 0.5), map: eye.map };
        world.seconds = block.motion.period / 2;
        moveBlocks(world);
        world.body = body;
        world.seconds = 0;
        moveBlocks(world);
        const ground = functions.groundUnder(map, body);
        world.body = null;
        world.seconds = expected.seconds;
        moveBlocks(world);
        if (ground > body.step)
          throw new Wrong(`: the block "${block.name}" shuts on a body that stands in its tile`);
      }
    },
  },
  reflect: {
    from: 18,
    run(reflect) {
      const [wall, sky, floor] = [
        [200, 40, 30],
        [60, 110, 220],
        [20, 160, 60],
      ];
      const slice = beforeAWall({ wall, sky, floor });
      const { height } = slice.picture;
      const [first, last] = [24, 72];
      // The eye is 0.5 above the floor, the wall 1.5 away: below the horizon, row 20, its mirror
      // image takes as many rows as the distance of the picture plane.
      reflect(slice, 0, last, first);
      const told = (row) =>
        Array.from(slice.picture.pixels.subarray(4 * row, 4 * row + 3)).join(', ');
      mustBe(', where the mirror shows a wall', told(40), wall.join(', '));
      mustBe(', where the mirror shows the sky above the wall', told(66), sky.join(', '));
      mustBe(', just below the upper edge of the wall in the mirror', told(59), wall.join(', '));
      for (let row = 0; row < height; row++) {
        const isMirror = row >= first && row < last;
        const where = `, a mirror in rows ${first} to ${last - 1}: \`open\` of row ${row}`;
        mustBe(where, slice.open[row], isMirror ? 0 : 1);
      }
    },
  },
  eyeBeyond: {
    from: 19,
    run(eyeBeyond, given) {
      const { world, eye, expected } = given;
      for (const { column, ray, hits, portals } of expected.columns) {
        const hit = hits.find((each) => each.portals === 1);
        const passed = portals.filter((each) => each.portals === 0);
        if (!hit || passed.length !== 1 || hit.face === null) continue;
        const [{ from, to, turn }] = passed;
        const portal = findPortalOf(world.maps[eye.map], from, to);
        if (!portal) continue;
        const beyond = eyeBeyond(eye, portal);
        let direction = ray;
        for (let i = 0; i < turn / 90; i++) direction = { x: -direction.y, y: direction.x };
        const where = `, column ${column}, where the ray meets "${hit.blueprint}" at depth ${shown(hit.depth)}`;
        mustBe(`${where}, x`, beyond?.x + direction.x * hit.depth, hit.point[0]);
        mustBe(`${where}, y`, beyond.y + direction.y * hit.depth, hit.point[1]);
      }
      const up = {
        x: 1,
        y: 4,
        level: 0,
        face: 'north',
        to: { map: eye.map, x: 6, y: 2, level: 1 },
      };
      const raised = eyeBeyond({ ...eye, z: 0.5 }, { ...up, turn: 1 });
      mustBe(', from level 0 to level 1, the eye at z 0.5: z', raised?.z, 1.5);
    },
  },
  'put whole pixels': {
    from: 21,
    run(put, { functions, eye, world }) {
      const pixels = new Uint8ClampedArray(4 * 8 * 6);
      let single = 0;
      const watched = new Proxy(pixels, {
        get(target, key) {
          if (key === 'set') single += 1;
          const value = Reflect.get(target, key, target);
          return typeof value === 'function' ? value.bind(target) : value;
        },
        set(target, key, value) {
          single += 1;
          target[key] = value;
          return true;
        },
      });
      functions.draw({ width: 8, height: 6, pixels: watched }, world, eye);
      void put;
      if (single > 0) tell(', bytes written one after another in 48 pixels', single, 0);
    },
  },
  'makeView exact': {
    from: 22,
    run(makeView, { eye }) {
      for (const [heading, x, y] of [
        [0, 1, 0],
        [90, 0, 1],
        [180, -1, 0],
        [270, 0, -1],
      ]) {
        const { forward } = makeView({ width: 8, height: 6 }, { ...eye, heading });
        if (forward.x !== x || forward.y !== y)
          throw new Wrong(
            `, heading ${heading}: \`forward\` is ${forward.x}, ${forward.y} and must be exactly ${x}, ${y}`,
          );
      }
    },
  },
  'walkGrid ties': {
    from: 22,
    run(walkGrid) {
      const map = { width: 4, depth: 4, levels: [['....', '....', '....', '....']], blocks: {} };
      // The eye counts as a little further east: borders to the east come first, to the west last.
      for (const [x, y, nextX, nextY] of [
        [1, 1, 2, 1],
        [1, -1, 2, 1],
        [-1, 1, 1, 2],
        [-1, -1, 1, 0],
      ]) {
        const tiles = walkGrid(map, { x: 1.5, y: 1.5, z: 0.5 }, { x, y });
        const mine = tiles?.[1] && `${tiles[1].x}, ${tiles[1].y}`;
        mustBe(
          `, the ray ${x}, ${y} through a corner, its second tile`,
          mine,
          `${nextX}, ${nextY}`,
        );
      }
      // Whoever divides 0 by a negative number gets -0, and then rows at the wrong infinity.
      const near = walkGrid(map, { x: 1, y: 1.5, z: 0.5 }, { x: -1, y: 0.5 })?.[1]?.near;
      const where = ', the eye on a border, the ray -1, 0.5, `near` of the second tile';
      mustBe(where, Object.is(near, -0) ? '-0' : near, 0);
    },
  },
};

function isMoving(map, { blueprint }) {
  return Object.values(map.blocks).some(({ name, motion }) => name === blueprint && motion);
}

const isTie = (a, b) => a !== null && b !== null && Math.abs(a - b) <= 1e-9 * a;

// Whether a run shows all of a side that is on the screen: a ceiling may hide some from above.
function isWhole({ first, last }, { topFrontRow, bottomFrontRow }, { height }) {
  const isAt = (row, edge) => Math.abs(row - edge) <= 1;
  const isExact = (edge) => isTie(edge, Math.floor(edge) + 0.5);
  if (isExact(topFrontRow) || isExact(bottomFrontRow)) return false;
  return (
    (first === 0 || isAt(first, topFrontRow)) && (last === height - 1 || isAt(last, bottomFrontRow))
  );
}

// A tile beside a wall that is higher than a step, with free tiles around.
function wallAhead({ expected, map }) {
  const isFree = (x, y) =>
    [-1, 0, 1].every((dx) =>
      [-1, 0, 1].every((dy) => {
        const row = map.levels[0][y + dy];
        return row !== undefined && !map.blocks[row[x + dx]];
      }),
    );
  for (const column of expected.columns) {
    const tiles = tilesOf(column);
    for (let i = 1; i < tiles.length; i++) {
      const [before, tile] = [tiles[i - 1], tiles[i]];
      const stepX = tile.x - before.x;
      const stepY = tile.y - before.y;
      const isWall = tile.blocks[0]?.bottom === 0 && tile.blocks[0].top > 0.5;
      const behind = [before.x - stepX, before.y - stepY];
      if (isWall && before.blocks.length === 0 && isFree(...behind))
        return { x: before.x, y: before.y, stepX, stepY };
    }
  }
  return null;
}

function offsetOf({ from, to, period, phase, shape }, seconds) {
  const at = (seconds / period + phase) % 1;
  const p = 2 * Math.min(at, 1 - at);
  const q = shape === 'stop-and-go' ? Math.min(Math.max(2 * p - 0.5, 0), 1) : p;
  return from + (to - from) * (shape === 'even' ? p : 3 * q * q - 2 * q ** 3);
}

function findPortalOf(map, from, to) {
  return map.portals.find(
    ({ x, y, to: exit }) =>
      [x, y].join() === [...from.tile].join() && exit.map === to.map && exit.x === to.tile[0],
  );
}
