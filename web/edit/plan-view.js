// The plan: one level seen from above, the levels below it pale, with objects, starts, lamps and
// links. A view as the picture is: it gives targets, and shows where the eye is.
// Takes a canvas, a document and an editor. Changes no document.
//
//     const plan = new PlanView(canvas, editor, colours, caster);
//     plan.draw();   plan.fit();
//
// `colours.of(sign, map)` is a CSS colour of a kind from above, or null for what is not there yet.

import { isInside, sizeOf } from './cells.js';
import { extentOf } from './shapes.js';
import { handlesOf } from './handles.js';
import { kindsOf } from './kinds.js';
import { PlanLinks } from './plan-links.js';
import { boxOfCells } from './tools/strokes.js';

const kLeastScale = 1; // CSS pixels a tile
const kMostScale = 96;
const kGridFrom = 7; // from this scale on there are lines between tiles
const kBelow = 0.38; // of what a level below shows through
const kSlack = 4; // CSS pixels that a click may move
const kNear = 10; // CSS pixels from the middle of a thing

export class PlanView {
  #canvas;
  #editor;
  #colours;
  #caster;
  #links;
  #scale = 0;
  #left = 0; // of the map's corner, CSS pixels
  #top = 0;
  #isDue = false;
  #pointers = new Map();
  #drag = null;
  #images = new Map(); // 'map level' -> {bitmap of one pixel a tile, version}
  #version = 0;

  constructor(canvas, editor, colours, caster) {
    this.#canvas = canvas;
    this.#editor = editor;
    this.#colours = colours;
    this.#caster = caster;
    this.#links = new PlanLinks(canvas.parentElement.querySelector('.legend'));
    new ResizeObserver(() => this.#resize()).observe(canvas);
    canvas.addEventListener('pointerdown', (event) => this.#down(event));
    canvas.addEventListener('pointermove', (event) => this.#move(event));
    canvas.addEventListener('pointerup', (event) => this.#up(event));
    canvas.addEventListener('pointercancel', (event) => this.#up(event));
    canvas.addEventListener('pointerleave', () => this.#drag === null && editor.point(null));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => this.#wheel(event), { passive: false });
    editor.listen(() => this.draw());
    editor.scene.listen(({ cells, isWhole }) => {
      if (isWhole) this.#version += 1;
      else for (const { map, layer } of cells) this.#images.delete(`${map} ${layer}`);
      this.draw();
    });
    colours.listen(() => {
      this.#version += 1;
      this.draw();
    });
    caster.addEventListener('viewchange', () => this.draw());
  }

  get #size() {
    return sizeOf(this.#editor.scene, this.#editor.map);
  }

  fit() {
    const { width, depth } = this.#size;
    const { clientWidth, clientHeight } = this.#canvas;
    if (clientWidth === 0 || width === 0) return;
    this.#scale = clamp(Math.min(clientWidth / (width + 2), clientHeight / (depth + 2)));
    this.#left = (clientWidth - width * this.#scale) / 2;
    this.#top = (clientHeight - depth * this.#scale) / 2;
    this.draw();
  }

  // Without a pointer, the tile of the eye is pointed at.
  aim() {
    const view = this.#caster.currentView;
    if (view?.map === this.#editor.mapName) this.#editor.point(this.#at(view.x, view.y));
  }

  draw() {
    if (this.#isDue || this.#canvas.clientWidth === 0) return;
    this.#isDue = true;
    requestAnimationFrame(() => {
      this.#isDue = false;
      this.#draw();
    });
  }

  #resize() {
    const { clientWidth, clientHeight } = this.#canvas;
    if (clientWidth === 0) return;
    this.#canvas.width = Math.round(clientWidth * devicePixelRatio);
    this.#canvas.height = Math.round(clientHeight * devicePixelRatio);
    if (this.#scale === 0) this.fit();
    this.draw();
  }

  // ---- Pointer

  #tileAt(event) {
    const box = this.#canvas.getBoundingClientRect();
    return [
      (event.clientX - box.left - this.#left) / this.#scale,
      (event.clientY - box.top - this.#top) / this.#scale,
    ];
  }

  // In the plan a block is placed where one points, and replaces what stands there.
  #find(event) {
    return this.#at(...this.#tileAt(event));
  }

  #at(x, y) {
    const { scene, map, mapName, level } = this.#editor;
    const at = { level, x: Math.floor(x), y: Math.floor(y) };
    if (!isInside(scene, map, at)) return null;
    return {
      map,
      mapName,
      cell: at,
      before: at,
      face: 'top',
      point: [x, y, level],
      thing: this.#editor.tool.hasThings ? this.#thingNear(x, y) : null,
      view: 'plan',
    };
  }

  #thingNear(x, y) {
    let [nearest, least] = [null, kNear / this.#scale];
    const { scene, map, edited } = this.#editor;
    for (const thing of handlesOf(scene, map, edited)) {
      const far = Math.hypot(thing.x - x, thing.y - y);
      if (far < least) [nearest, least] = [thing.path, far];
    }
    return nearest;
  }

  #down(event) {
    event.preventDefault();
    this.#canvas.focus({ preventScroll: true });
    this.#canvas.setPointerCapture(event.pointerId);
    this.#pointers.set(event.pointerId, [event.clientX, event.clientY]);
    if (this.#pointers.size > 1) {
      this.#editor.cancel();
      this.#drag = null;
      return;
    }
    this.#drag = { button: event.button, x: event.clientX, y: event.clientY, isMoved: false };
    const target = this.#find(event);
    if (target === null || event.button !== 0) return;
    if (event.altKey) this.#editor.pick(target);
    else this.#editor.press(target, { removes: event.ctrlKey });
  }

  #move(event) {
    const before = this.#pointers.get(event.pointerId);
    if (before !== undefined) {
      const [right, down] = [event.clientX - before[0], event.clientY - before[1]];
      if (this.#pointers.size > 1) this.#pinch(event, before);
      else if (this.#drag !== null && this.#drag.button !== 0) this.#pan(event, right, down);
      this.#pointers.set(event.pointerId, [event.clientX, event.clientY]);
    }
    this.#editor.isWhole = event.shiftKey;
    if (this.#pointers.size < 2) this.#editor.point(this.#find(event));
  }

  #pan({ clientX, clientY }, right, down) {
    const drag = this.#drag;
    if (Math.hypot(clientX - drag.x, clientY - drag.y) > kSlack) drag.isMoved = true;
    if (!drag.isMoved) return;
    this.#left += right;
    this.#top += down;
    this.draw();
  }

  #pinch(event, before) {
    const [, other] = [...this.#pointers].find(([id]) => id !== event.pointerId);
    const far = (x, y) => Math.hypot(x - other[0], y - other[1]);
    this.#zoom(far(event.clientX, event.clientY) / Math.max(1, far(...before)), event);
    this.#left += (event.clientX - before[0]) / 2;
    this.#top += (event.clientY - before[1]) / 2;
  }

  #up(event) {
    this.#pointers.delete(event.pointerId);
    const drag = this.#drag;
    if (drag === null || this.#pointers.size > 0) return;
    this.#drag = null;
    if (drag.button === 0) this.#editor.release();
    const target = this.#find(event);
    if (target === null || drag.isMoved) return;
    if (drag.button === 1) this.#editor.pick(target);
    if (drag.button === 2) {
      this.#editor.press(target, { removes: true });
      this.#editor.release();
    }
  }

  #wheel(event) {
    event.preventDefault();
    const notches = -Math.sign(event.deltaY);
    const { stroke, target } = this.#editor;
    if ((stroke !== null || target?.thing) && this.#editor.turn(notches)) return;
    this.#zoom(1.2 ** notches, event);
  }

  #zoom(factor, { clientX, clientY }) {
    const box = this.#canvas.getBoundingClientRect();
    const [x, y] = [clientX - box.left, clientY - box.top];
    const scale = clamp(this.#scale * factor);
    this.#left = x - ((x - this.#left) * scale) / this.#scale;
    this.#top = y - ((y - this.#top) * scale) / this.#scale;
    this.#scale = scale;
    this.draw();
  }

  // ---- Drawing

  #draw() {
    const { scene, map, level } = this.#editor;
    const context = this.#canvas.getContext('2d');
    const { width, depth, levels } = this.#size;
    const scale = this.#scale;
    context.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    context.clearRect(0, 0, this.#canvas.clientWidth, this.#canvas.clientHeight);
    context.translate(this.#left, this.#top);
    context.imageSmoothingEnabled = false;
    context.fillStyle = this.#colours.floor(map) ?? '#5a5148';
    context.fillRect(0, 0, width * scale, depth * scale);
    for (let below = 0; below <= Math.min(level, levels - 1); ++below) {
      const image = this.#imageOf(map, below);
      context.globalAlpha = below === level ? 1 : kBelow;
      if (image !== null) context.drawImage(image, 0, 0, width * scale, depth * scale);
    }
    context.globalAlpha = 1;
    if (scale >= kGridFrom) this.#grid(context, width, depth);
    this.#links.draw(context, this.#editor, scale);
    this.#things(context, scene.value.maps[map]);
    this.#pointed(context);
    this.#eye(context);
  }

  // One pixel a tile.
  #imageOf(map, level) {
    const key = `${map} ${level}`;
    const known = this.#images.get(key);
    if (known?.version === this.#version) return known.image;
    const { width, depth } = this.#size;
    const { scene } = this.#editor;
    if (scene.rows(map, level).length === 0) return null;
    const kinds = new Map(kindsOf(scene, map).map(({ sign, blueprint }) => [sign, blueprint]));
    const image = new OffscreenCanvas(width, depth);
    const context = image.getContext('2d');
    for (let y = 0; y < depth; ++y) {
      for (let x = 0; x < width; ++x) {
        const sign = scene.sign(map, level, x, y);
        const blueprint = kinds.get(sign);
        if (blueprint === undefined) continue;
        const { high } = extentOf(blueprint);
        context.globalAlpha = 0.55 + 0.45 * high;
        context.fillStyle = this.#colours.of(blueprint) ?? '#8a8078';
        context.fillRect(x, y, 1, 1);
      }
    }
    this.#images.set(key, { image, version: this.#version });
    return image;
  }

  #grid(context, width, depth) {
    context.strokeStyle = 'rgb(0 0 0 / 0.18)';
    context.lineWidth = 1;
    context.beginPath();
    for (let x = 0; x <= width; ++x) {
      context.moveTo(x * this.#scale, 0);
      context.lineTo(x * this.#scale, depth * this.#scale);
    }
    for (let y = 0; y <= depth; ++y) {
      context.moveTo(0, y * this.#scale);
      context.lineTo(width * this.#scale, y * this.#scale);
    }
    context.stroke();
  }

  #things(context, map) {
    const scale = this.#scale;
    const radius = Math.max(2, Math.min(8, scale * 0.28));
    const dot = ({ x, y }, colour) => {
      context.beginPath();
      context.arc(x * scale, y * scale, radius, 0, 2 * Math.PI);
      context.fillStyle = colour;
      context.fill();
      context.lineWidth = 1.5;
      context.strokeStyle = '#15131c';
      context.stroke();
    };
    for (const object of map.objects ?? []) dot(object, '#8fce7a');
    for (const lamp of map.baked?.lamps ?? []) dot(lamp, '#ffe9a0');
    const { start } = this.#editor.scene.value;
    const startMap = start?.map ?? this.#editor.scene.value.maps[0].name;
    if (start !== undefined && startMap === map.name) {
      dot(start, '#e3835f');
      const angle = ((start.heading ?? 0) * Math.PI) / 180;
      const to = { x: start.x + Math.cos(angle), y: start.y + Math.sin(angle) };
      arrow(context, start, to, scale, '#e3835f');
    }
  }

  #pointed(context) {
    const { target, stroke, map, tool } = this.#editor;
    if (tool.hasThings) this.#flatMarks(context);
    if (tool.hasThings || target === null || target.map !== map) return;
    const at = stroke?.removes ? target.cell : (target.before ?? target.cell);
    if (at === null) return;
    const isBox = stroke !== null && tool.show !== undefined;
    const first = isBox ? (stroke.targets[0].before ?? stroke.targets[0].cell) : at;
    const { from, to } = boxOfCells(first, at);
    context.strokeStyle = stroke?.removes ? '#e3835f' : '#ecc862';
    context.lineWidth = 2;
    context.strokeRect(
      from.x * this.#scale,
      from.y * this.#scale,
      (to.x - from.x + 1) * this.#scale,
      (to.y - from.y + 1) * this.#scale,
    );
  }

  // What the tool shows in the picture, seen from above.
  #flatMarks(context) {
    const { toolMarks, mapName } = this.#editor;
    context.lineWidth = 2;
    for (const { map, from, to, colour } of toolMarks) {
      if (map !== mapName) continue;
      context.strokeStyle = colour;
      context.beginPath();
      context.moveTo(from[0] * this.#scale, from[1] * this.#scale);
      context.lineTo(to[0] * this.#scale, to[1] * this.#scale);
      context.stroke();
    }
  }

  #eye(context) {
    const view = this.#caster.currentView;
    if (view === null || view.map !== this.#editor.mapName) return;
    const angle = (view.heading * Math.PI) / 180;
    const far = Math.max(18, this.#scale * 1.5);
    const [x, y] = [view.x * this.#scale, view.y * this.#scale];
    context.beginPath();
    context.moveTo(x, y);
    context.arc(x, y, far, angle - 0.5, angle + 0.5);
    context.closePath();
    context.fillStyle = 'rgb(255 255 255 / 0.35)';
    context.fill();
    context.beginPath();
    context.arc(x, y, 4, 0, 2 * Math.PI);
    context.fillStyle = '#fff';
    context.fill();
    context.strokeStyle = '#15131c';
    context.stroke();
  }
}

function arrow(context, from, to, scale, colour) {
  const angle = Math.atan2(to.y - from.y, to.x - from.x);
  const [x, y] = [to.x * scale, to.y * scale];
  context.beginPath();
  context.moveTo(from.x * scale, from.y * scale);
  context.lineTo(x, y);
  for (const side of [-0.5, 0.5]) {
    context.moveTo(x, y);
    context.lineTo(x - 8 * Math.cos(angle + side), y - 8 * Math.sin(angle + side));
  }
  context.strokeStyle = colour;
  context.lineWidth = 2;
  context.stroke();
}

function clamp(scale) {
  return Math.min(kMostScale, Math.max(kLeastScale, scale));
}
