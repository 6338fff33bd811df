// Where figures get their answers: a <ray-caster> in a page, or a scene under Node. Both give the
// same answers to the same questions, for a picture of a fixed size.
//
//     const source = nodeSource(scene, { scene: json, size: [480, 300] });
//     const source = elementSource(caster, { scene: json, size: [480, 300] });

export function nodeSource(
  scene,
  { scene: json = null, size = [480, 300], address = (file) => file } = {},
) {
  const [width, height] = size;
  const itsSize = { width, height };
  return Object.assign(common(scene, json, address), {
    size,
    isUsed: true,
    trace: (columns) => scene.trace(columns, itsSize),
    traceFrame: () => scene.trace(undefined, itsSize),
    hits: (columns) => scene.hits(columns, itsSize),
    pick: (column, row) => scene.pick(column, row, itsSize),
    project: (x, y, z, map) => scene.project(x, y, z, map, itsSize),
    pixels: (wanted = itsSize) => scene.pixels(wanted),
  });
}

// The element's attribute `size` must be the same size.
export function elementSource(
  caster,
  { scene: json = null, size = [480, 300], address = (file) => file } = {},
) {
  const [width, height] = size;
  return Object.assign(common(caster, json, address), {
    size,
    isUsed: false,
    caster,
    trace: (columns) => caster.trace(columns),
    traceFrame: () => caster.trace(),
    hits: (columns) => caster.hits(columns),
    pick(column, row) {
      // The element is asked about points of the window.
      const frame = caster.shadowRoot.querySelector('canvas').getBoundingClientRect();
      const x = frame.left + ((column + 0.5) * frame.width) / width;
      const y = frame.top + ((row + 0.5) * frame.height) / height;
      return caster.pick(x, y);
    },
    project(x, y, z, map) {
      const point = caster.project(x, y, z, map);
      return point === null ? null : { x: point.x, y: point.y, depth: point.depth };
    },
    pixels: (wanted = { width, height }) => caster.pixels(wanted),
  });
}

function common(engine, json, address) {
  let kept = { key: null };
  return {
    scene: json,
    address,
    image: address, // what markup names
    get view() {
      return engine.currentView;
    },
    get world() {
      return engine.world;
    },
    get oldWays() {
      return engine.oldWays;
    },
    standard: (name) => engine.optionList.find((option) => option.name === name)?.standard,
    set: (name, value) => engine.set(name, value),
    get: (name) => engine.get(name),
    look: (view) => engine.look(view),
    cast: (from) => engine.cast(from),
    cells: (map, level) => engine.cells(map ?? undefined, level),
    blueprints: (map) => engine.blueprints(map ?? undefined),
    setCell: (map, level, x, y, character) =>
      engine.setCell(map ?? undefined, level, x, y, character),
    step: (count, input) => engine.step(count, input),
    reset: () => engine.reset(),
    // The colours of a pixel: without any light or fog, with baked light, without fog, and as it is
    // drawn. `key` tells
    // pictures apart: the answer is kept for as long as it stays the same.
    colours(column, row, key = null) {
      if (key === null || kept.key !== key) {
        const draw = () => this.pixels();
        const before = ['light', 'fog', 'baked'].map((name) => [name, engine.get(name)]);
        const picture = draw();
        engine.set('fog', 'off');
        const light = draw();
        engine.set('light', 'off');
        const baked = draw();
        engine.set('baked', 'off');
        const texel = draw();
        for (const [name, value] of before) engine.set(name, value);
        kept = { key, pictures: { texel, baked, light, picture } };
      }
      const at = 4 * (row * this.size[0] + column);
      return Object.fromEntries(
        Object.entries(kept.pictures).map(([name, { data }]) => [
          name,
          [...data.subarray(at, at + 3)],
        ]),
      );
    },
  };
}
