// The plan: one level seen from above, the levels below it pale, with objects, starts, lamps and
// portals. A view as the picture is: it gives targets, and shows where the eye is.
// Takes a canvas, a document and an editor. Changes no document.
//
//     const plan = new PlanView(canvas, editor, colours, caster);
//     plan.draw();   plan.fit();
//
// `colours.of(blueprint)` is a CSS colour of a kind from above, `colours.texture(name)` of a
// texture, or null for what is not there yet.

import { CanvasView, countTo } from './canvas-view.js';
import { isInside, sizeOf } from './cells.js';
import { extentOf } from './shapes.js';
import { kindsOf } from './kinds.js';
import { handlesOf } from './handles.js';
import { kLinkLooks } from './link-looks.js';
import { paintThing, thingColour } from './thing-icons.js';
import { valueAt } from './things.js';
import { PlanLinks } from './plan-links.js';
import { paintOverlay } from './plan-overlay.js';
import { textureOfTile } from './tiles.js';

const kMostScale = 96; // CSS pixels a tile
const kGridFrom = 7; // from this scale on there are lines between tiles
const kBelow = 0.38; // of what a level below shows through
const kInside = 0.05; // units from the edge of the map, at least, in a stroke
const [kLeastIcon, kMostIcon] = [14, 30]; // CSS pixels, of things
const kDot = 4.5; // CSS pixels, of ends of portals: their frames and arrows are links
const kShare = 0.9; // of it, by the picture of an object
const kNear = 10; // CSS pixels from the middle of a thing

const kArrows = { ArrowUp: [0, -1], ArrowRight: [1, 0], ArrowDown: [0, 1], ArrowLeft: [-1, 0] };

export class PlanView extends CanvasView {
  #colours;
  #caster;
  #links;
  #images = new Map(); // 'map level' -> {bitmap of one pixel a tile, version}
  #version = 0;

  constructor(canvas, editor, colours, caster) {
    super(canvas, editor, kMostScale);
    this.#colours = colours;
    this.#caster = caster;
    this.#links = new PlanLinks(document.querySelector('.legend'));
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

  get bounds() {
    const { width, depth } = this.#size;
    return [0, 0, width, depth];
  }

  get #size() {
    return sizeOf(this.editor.scene, this.editor.map);
  }

  boxOf(from, to) {
    return [from.x, from.y, to.x - from.x + 1, to.y - from.y + 1];
  }

  // Without a pointer, the tile of the eye is pointed at.
  aim() {
    const view = this.#caster.currentView;
    if (view?.map === this.editor.mapName) this.editor.point(this.find([view.x, view.y]));
  }

  // Arrows go from tile to tile, from where one points, or else from the eye.
  take(event) {
    const step = kArrows[event.key];
    if (step === undefined) return super.take(event);
    const { target } = this.editor;
    if (target?.view !== 'plan') {
      this.aim();
      return true;
    }
    const [x, y] = [target.cell.x + step[0] + 0.5, target.cell.y + step[1] + 0.5];
    this.editor.point(this.find([x, y]) ?? target);
    return true;
  }

  // The wheel over a handle is the tool's.
  step(notches) {
    return this.editor.target?.thing ? this.editor.turn(notches) : false;
  }

  // In the plan a block is placed where one points, and replaces what stands there.
  find([x, y]) {
    const { scene, map, mapName, level, stroke } = this.editor;
    // A stroke goes on to the edge of the map.
    if (stroke !== null) [x, y] = this.#within([x, y]);
    const at = { level, x: Math.floor(x), y: Math.floor(y) };
    if (!isInside(scene, map, at)) return null;
    return {
      map,
      mapName,
      cell: at,
      before: at,
      face: 'top',
      point: [x, y, level],
      thing: this.editor.tool.hasThings ? this.#thingNear(x, y) : null,
      view: 'plan',
    };
  }

  #within([x, y]) {
    const { width, depth } = this.#size;
    const limit = (at, end) => Math.max(kInside, Math.min(end - kInside, at));
    return [limit(x, width), limit(y, depth)];
  }

  #thingNear(x, y) {
    let [nearest, least] = [null, kNear / this.scale];
    const { scene, map, edited } = this.editor;
    for (const thing of handlesOf(scene, map, edited)) {
      const far = Math.hypot(thing.x - x, thing.y - y);
      if (far < least) [nearest, least] = [thing.path, far];
    }
    return nearest;
  }

  // ---- Drawing

  paint(context) {
    const { map, level, tool, way } = this.editor;
    const { width, depth, levels } = this.#size;
    const { scale } = this;
    context.fillStyle = this.#colours.floor(map) ?? '#5a5148';
    context.fillRect(0, 0, width * scale, depth * scale);
    const tiles = this.#tilesOf(map, 'floor');
    if (tiles !== null) context.drawImage(tiles, 0, 0, width * scale, depth * scale);
    for (let below = 0; below <= Math.min(level, levels - 1); ++below) {
      const image = this.#imageOf(map, below);
      context.globalAlpha = below === level ? 1 : kBelow;
      if (image !== null) context.drawImage(image, 0, 0, width * scale, depth * scale);
    }
    context.globalAlpha = 1;
    if (tool.name === 'paint' && way === 'ceiling') {
      const above = this.#tilesOf(map, 'ceiling');
      if (above !== null) context.drawImage(above, 0, 0, width * scale, depth * scale);
    }
    if (scale >= kGridFrom) this.grid(context, countTo(width), countTo(depth), this.bounds);
    this.#section(context, width, depth);
    this.#links.draw(context, this.editor, scale);
    this.#things(context, map);
    this.#eye(context);
  }

  // Where the side view cuts the map.
  #section(context, width, depth) {
    const { section } = this.editor;
    if (section === null) return;
    const middle = (section.at + 0.5) * this.scale;
    const ends =
      section.axis === 'x'
        ? [0, middle, width * this.scale, middle]
        : [middle, 0, middle, depth * this.scale];
    context.beginPath();
    context.moveTo(ends[0], ends[1]);
    context.lineTo(ends[2], ends[3]);
    context.setLineDash([8, 6]);
    context.strokeStyle = '#f7f1e1';
    context.lineWidth = 2;
    context.stroke();
    context.setLineDash([]);
  }

  // One pixel a tile.
  #imageOf(map, level) {
    const key = `${map} ${level}`;
    const known = this.#images.get(key);
    if (known?.version === this.#version) return known.image;
    const { width, depth } = this.#size;
    const { scene } = this.editor;
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

  pointed(context) {
    if (this.editor.tool.hasThings) this.#flatMarks(context);
    else if (!paintOverlay(context, this.editor, this.scale)) super.pointed(context);
  }

  // What the tool shows in the picture, seen from above.
  #flatMarks(context) {
    const { toolMarks, mapName } = this.editor;
    context.lineWidth = 2;
    for (const { map, from, to, colour } of toolMarks) {
      if (map !== mapName) continue;
      context.strokeStyle = colour;
      context.beginPath();
      context.moveTo(from[0] * this.scale, from[1] * this.scale);
      context.lineTo(to[0] * this.scale, to[1] * this.scale);
      context.stroke();
    }
  }

  // Of floor or ceiling, one pixel a tile; null if it has no tiles.
  #tilesOf(map, layer) {
    const key = `${map} ${layer}`;
    const known = this.#images.get(key);
    if (known?.version === this.#version) return known.image;
    const { scene } = this.editor;
    const { width, depth } = this.#size;
    const { tiles } = scene.value.maps[map][layer] ?? {};
    const isPlain = layer === 'floor' && tiles === undefined;
    let image = null;
    if (!isPlain && width > 0) {
      image = new OffscreenCanvas(width, depth);
      const context = image.getContext('2d');
      for (let y = 0; y < depth; ++y) {
        for (let x = 0; x < width; ++x) {
          const texture = textureOfTile(scene, map, layer, x, y);
          if (texture === null) continue;
          context.fillStyle = this.#colours.texture(texture) ?? '#5a5148';
          context.fillRect(x, y, 1, 1);
        }
      }
    }
    this.#images.set(key, { image, version: this.#version });
    return image;
  }

  #things(context, map) {
    const { scene, target, edited } = this.editor;
    const { start } = scene.value;
    const size = Math.max(kLeastIcon, Math.min(kMostIcon, this.scale));
    for (const { path, kind, x, y } of handlesOf(scene, map, null)) {
      if (kind === 'way') continue; // drawn with its links
      if (kind === 'start') {
        const angle = ((start.heading ?? 0) * Math.PI) / 180;
        this.arrow(context, [x, y], [x + Math.cos(angle), y + Math.sin(angle)], thingColour(kind));
      }
      context.save();
      context.translate(x * this.scale, y * this.scale);
      const is = (other) => String(other) === String(path);
      if (is(target?.thing) || is(edited)) halo(context, kind === 'portal' ? 2 * kDot : size);
      if (kind === 'object') this.#object(context, valueAt(scene.value, path), size);
      else if (kind === 'portal') disc(context, kDot, kLinkLooks.portal.colour);
      else {
        context.translate(-size / 2, -size / 2);
        paintThing(context, kind, size);
      }
      context.restore();
    }
  }

  // Its picture; a dot until it is there.
  #object(context, { sprite, find }, size) {
    const image = this.#colours.sprite(sprite);
    if (image === null) {
      this.dot(context, [0, 0], thingColour('object'));
      return;
    }
    if (find === undefined) backing(context, size);
    const scale = (size * kShare) / Math.max(image.width, image.height);
    const [width, height] = [image.width * scale, image.height * scale];
    context.drawImage(image, -width / 2, -height / 2, width, height);
  }

  #eye(context) {
    const view = this.#caster.currentView;
    if (view === null || view.map !== this.editor.mapName) return;
    this.eye(context, [view.x, view.y], (view.heading * Math.PI) / 180);
  }
}

function backing(context, size) {
  disc(context, size / 2, 'rgb(247 241 225 / 0.5)');
}

// Of what is pointed at or edited.
function halo(context, size) {
  disc(context, size / 2 + 3, '#ffffff');
}

function disc(context, radius, colour) {
  context.beginPath();
  context.arc(0, 0, radius, 0, 2 * Math.PI);
  context.fillStyle = colour;
  context.fill();
}
