// Explains a pixel of the paused picture: its ray, tile, block, texel and light, and what the ray
// meets from front to back. A click, a tap or the arrow keys choose the pixel. The picture makes
// room for the panel, so nothing of it is covered.
//
//     const explain = new ExplainPixel(panel, cover, caster);
//     explain.begin();
//
// `cover` lies over the picture and takes clicks and keys; its only child marks the pixel.

const kNear = 5; // pixels around the chosen one, on each side, that the close-up shows
const kLongStep = 10; // pixels that the arrow keys move by with Shift
const kColours = ['red', 'green', 'blue'];
const kSvg = 'http://www.w3.org/2000/svg';
const kPlanMargin = 0.6; // tiles
const kLeastPlan = 5; // tiles that the plan shows at least
const kMostTiles = 400; // and at most; a ray to the sky walks over the whole map

const kMoves = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};
const kThings = {
  side: 'the side of a block',
  roof: 'the top of a block',
  underside: 'the underside of a block',
  floor: 'the floor',
  ceiling: 'the ceiling',
  sky: 'the sky',
  haze: 'haze',
  object: 'an object',
};

export class ExplainPixel {
  #panel;
  #cover;
  #mark;
  #caster;
  #pixel = null; // {column, row, width, height} of the picture; null while nothing is explained

  constructor(panel, cover, caster) {
    this.#panel = panel;
    this.#cover = cover;
    this.#mark = cover.firstElementChild;
    this.#caster = caster;
    for (const type of ['pointerdown', 'pointermove'])
      cover.addEventListener(type, (event) => this.#point(event));
    for (const part of [cover, panel])
      part.addEventListener('keydown', (event) => this.#key(event, part === cover));
    this.#part('close').addEventListener('click', () => this.end());
    caster.addEventListener('framechange', () => this.#show());
    // Playing ends it, and so does another scene.
    caster.addEventListener('enterchange', () => caster.entered && this.end());
    for (const type of ['ready', 'error']) caster.addEventListener(type, () => this.end());
    new ResizeObserver(() => this.#show()).observe(caster);
  }

  get isOn() {
    return this.#pixel !== null;
  }

  begin() {
    if (this.#caster.world === null || this.isOn) return;
    this.#caster.pause();
    this.#panel.hidden = this.#cover.hidden = false;
    document.body.classList.add('explaining');
    const { width, height } = this.#caster.picture;
    this.#pixel = { column: width >> 1, row: height >> 1, width, height };
    this.#show();
    this.#cover.focus({ preventScroll: true });
  }

  end() {
    if (!this.isOn) return;
    const hadFocus = [this.#panel, this.#cover].some((part) =>
      part.contains(document.activeElement),
    );
    this.#pixel = null;
    this.#panel.hidden = this.#cover.hidden = true;
    document.body.classList.remove('explaining');
    if (hadFocus && !this.#caster.entered) this.#caster.focus({ preventScroll: true });
  }

  // ---- Choosing

  #point(event) {
    if (event.type === 'pointermove' && event.buttons === 0) return;
    event.preventDefault(); // no scrolling, no selection
    this.#cover.focus({ preventScroll: true });
    const { left, top, width, height } = this.#box();
    const picture = this.#caster.picture;
    this.#choose(
      Math.floor(((event.clientX - left) * picture.width) / width),
      Math.floor(((event.clientY - top) * picture.height) / height),
    );
  }

  #key(event, isCover) {
    const move = isCover ? kMoves[event.key] : undefined;
    if (event.key !== 'Escape' && move === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    if (move === undefined) return this.end();
    const by = event.shiftKey ? kLongStep : 1;
    this.#choose(this.#pixel.column + by * move[0], this.#pixel.row + by * move[1]);
  }

  #choose(column, row) {
    const { width, height } = this.#caster.picture;
    this.#pixel = {
      column: clamp(column, width - 1),
      row: clamp(row, height - 1),
      width,
      height,
    };
    this.#show();
  }

  // ---- Showing

  #show() {
    if (!this.isOn || this.#caster.world === null) return;
    // The picture may have another size now.
    const { width, height } = this.#caster.picture;
    const last = this.#pixel;
    if (last.width !== width || last.height !== height) {
      const column = Math.floor(((last.column + 0.5) * width) / last.width);
      const row = Math.floor(((last.row + 0.5) * height) / last.height);
      this.#pixel = { column, row, width, height };
    }
    const { column, row } = this.#pixel;
    const box = this.#box();
    const size = { x: box.width / width, y: box.height / height };
    const cover = this.#cover.getBoundingClientRect();
    const { style } = this.#mark;
    style.left = `${box.left - cover.left + column * size.x}px`;
    style.top = `${box.top - cover.top + row * size.y}px`;
    style.width = `${size.x}px`;
    style.height = `${size.y}px`;

    const pick = this.#caster.pick(
      box.left + (column + 0.5) * size.x,
      box.top + (row + 0.5) * size.y,
    );
    const trace = this.#caster.trace(column);
    if (pick === null || trace === null) return;
    const colour = this.#closeUp(column, row);
    this.#part('colour').style.background = colour;
    this.#part('summary').textContent = summaryOf(pick);
    this.#part('facts').replaceChildren(
      ...[['Pixel', `column ${column}, row ${row}, ${colour}`], ...factsOf(pick, trace)].flatMap(
        ([name, text]) => [textNode('dt', name), textNode('dd', text)],
      ),
    );
    this.#part('layers').replaceChildren(
      ...layersOf(pick, trace, row).map((text) => textNode('li', text)),
    );
    drawPlan(this.#part('plan'), pick, trace);
  }

  // Draws the pixels around the chosen one; returns its colour.
  #closeUp(column, row) {
    const canvas = this.#part('near');
    const side = 2 * kNear + 1;
    canvas.width = canvas.height = side;
    const context = canvas.getContext('2d', { willReadFrequently: true });
    context.drawImage(this.#picture, column - kNear, row - kNear, side, side, 0, 0, side, side);
    const [red, green, blue] = context.getImageData(kNear, kNear, 1, 1).data;
    return `#${[red, green, blue].map((part) => part.toString(16).padStart(2, '0')).join('')}`;
  }

  get #picture() {
    return this.#caster.shadowRoot.querySelector('[part~="picture"]');
  }

  #box() {
    return this.#picture.getBoundingClientRect();
  }

  #part(name) {
    return this.#panel.querySelector(`[data-explain="${name}"]`);
  }
}

// ---- Words

const units = (number) => number.toFixed(2);
const kFixedBlank = '\u00a0'; // where no line ends
const share = (part, whole) => `${Math.round((100 * part) / whole)}${kFixedBlank}%`;

function summaryOf({ what, blueprint, face, texture, reflection }) {
  const name = blueprint ?? (what === 'object' ? texture : null);
  const of = name === null ? kThings[what] : `${kThings[what]}: ${name}`;
  const side = what === 'side' && face !== null ? `, facing ${face}` : '';
  const mirrored = reflection === null ? '' : `, a mirror of ${kThings[reflection.what]}`;
  const text = of + side + mirrored;
  return text[0].toUpperCase() + text.slice(1);
}

// Pairs of a name and a text.
function factsOf(pick, trace) {
  const { texel, tile, level, point, depth, portals } = pick;
  const [x, y] = trace.ray;
  const heading = ((Math.atan2(y, x) * 180) / Math.PI + 360) % 360;
  const walked = trace.tiles.filter((entered) => depth === null || entered[2] <= depth);
  const facts = [
    [
      'Ray',
      `heading ${heading.toFixed(1)}°, ${counted(walked.length, 'tile')} walked` +
        (portals > 0 ? `, through ${counted(portals, 'portal')}` : ''),
    ],
  ];
  if (tile !== null)
    facts.push([
      'Tile',
      `${tile.join(', ')}${level === null ? '' : `, level ${level}`}, map ${pick.map}`,
    ]);
  if (point !== null)
    facts.push(['Point', `${point.map(units).join(', ')}; depth ${units(depth)}`]);
  if (texel === null) return facts;
  const { detail, size, u, v, baked, light, fog } = texel;
  facts.push([
    'Texel',
    `${u}, ${v} of ${size.join(' × ')} in ${pick.texture}, detail ${detail}` +
      (pick.alpha < 255 ? `, ${share(pick.alpha, 255)} opaque` : ''),
  ]);
  const isLit = baked.some((part) => part !== 256);
  facts.push([
    'Light',
    share(light, 256) +
      (isLit
        ? `, baked light ${baked.map((part, index) => `${kColours[index]}${kFixedBlank}${share(part, 256)}`).join(', ')}`
        : ''),
  ]);
  facts.push(['Haze', share(fog, 255)]);
  return facts;
}

// What fills that row, from front to back. What comes before the picked thing has a hole there.
function layersOf(pick, { runs }, row) {
  const here = runs.filter(({ first, last }) => first <= row && row <= last);
  const picked = here.findIndex(
    ({ what, texture, face }) =>
      what === pick.what && texture === pick.texture && face === pick.face,
  );
  return here.map((run, index) => {
    const name = run.texture === null ? kThings[run.what] : `${kThings[run.what]}, ${run.texture}`;
    if (index < picked) return `${name}: a hole here`;
    return run.layer ? `${name}: a layer` : name;
  });
}

function counted(count, name) {
  return `${count} ${name}${count === 1 ? '' : 's'}`;
}

// ---- The ray from above, in the map of the eye

function drawPlan(svg, pick, trace) {
  const { eye, map, ray } = trace;
  const isHere = pick.map === map && pick.portals === 0;
  const end = isHere ? pick.depth : null;
  const tiles = trace.tiles
    .filter(([, , depth, of]) => of === map && (end === null || depth <= end + 1e-6))
    .slice(0, kMostTiles);
  const last = tiles.at(-1)?.[2] ?? 0;
  const depth = end ?? last;
  const to = [eye.x + ray[0] * depth, eye.y + ray[1] * depth];
  const xs = [eye.x, to[0], ...tiles.flatMap(([x]) => [x, x + 1])];
  const ys = [eye.y, to[1], ...tiles.flatMap(([, y]) => [y, y + 1])];
  const [left, top] = [Math.min(...xs), Math.min(...ys)];
  const [right, bottom] = [Math.max(...xs), Math.max(...ys)];
  const side = Math.max(kLeastPlan, right - left, bottom - top) + 2 * kPlanMargin;
  svg.setAttribute(
    'viewBox',
    [(left + right - side) / 2, (top + bottom - side) / 2, side, side].join(' '),
  );
  const square = (x, y, kind) => shape('rect', { x, y, width: 1, height: 1, class: kind });
  svg.replaceChildren(
    ...tiles.map(([x, y]) => square(x, y, 'tile')),
    ...(isHere && pick.tile !== null ? [square(...pick.tile, 'end-tile')] : []),
    shape('line', { x1: eye.x, y1: eye.y, x2: to[0], y2: to[1], class: 'ray' }),
    shape('circle', { cx: eye.x, cy: eye.y, r: side / 40, class: 'eye' }),
    ...(end === null
      ? []
      : [shape('circle', { cx: to[0], cy: to[1], r: side / 40, class: 'end' })]),
  );
}

function shape(name, attributes) {
  const element = document.createElementNS(kSvg, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
}

function textNode(name, text) {
  const element = document.createElement(name);
  element.textContent = text;
  return element;
}

function clamp(value, most) {
  return Math.max(0, Math.min(most, value));
}
