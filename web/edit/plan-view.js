// The plan: one level seen from above, the levels below it pale, with objects, starts, lamps and
// portals. A view as the picture is: it gives targets, and shows where the eye is.
// Takes a canvas, a document and an editor. Changes no document.
//
//     const plan = new PlanView(canvas, editor, colours, caster);
//     plan.draw();   plan.fit();
//
// `colours.of(blueprint)` is a CSS colour of a kind from above, `colours.texture(name)` of a
// texture, or null for what is not there yet.

import { signsOf } from '../engine/signs.js';
import { CanvasView, countTo } from './canvas-view.js';
import { isInside, kEmpty, sizeOf } from './cells.js';
import { extentOf } from './shapes.js';
import { kindsOf } from './kinds.js';
import { handlesOf } from './handles.js';
import { kLinkLooks } from './link-looks.js';
import { paintThing, thingColour } from './thing-icons.js';
import { valueAt } from './things.js';
import { PlanLinks } from './plan-links.js';
import { paintOverlay } from './plan-overlay.js';
import { kOpen, textureOfSign } from './tiles.js';

const kMostScale = 96; // CSS pixels a tile
const kGridFrom = 7; // from this scale on there are lines between tiles
const kBelow = 0.38; // of what a level below shows through
const kInside = 0.05; // units from the edge of the map, at least, in a stroke
const [kLeastIcon, kMostIcon] = [14, 30]; // CSS pixels, of things
const kDot = 4.5; // CSS pixels, of ends of portals: their frames and arrows are links
const kShare = 0.9; // of it, by the picture of an object
const kNear = 10; // CSS pixels from the middle of a thing
const kMostIcons = 1000; // in sight: of more things, objects are specks

const kArrows = { ArrowUp: [0, -1], ArrowRight: [1, 0], ArrowDown: [0, 1], ArrowLeft: [-1, 0] };

export class PlanView extends CanvasView {
  #colours;
  #caster;
  #links;
  #images = new Map(); // 'map level' -> {image of one pixel a tile, rows, looks}

  constructor(canvas, editor, colours, caster) {
    super(canvas, editor, kMostScale);
    this.#colours = colours;
    this.#caster = caster;
    this.#links = new PlanLinks(document.querySelector('.legend'));
    editor.scene.listen(() => this.draw());
    colours.listen(() => this.draw());
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
      const image = this.#levelOf(map, below);
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

  #levelOf(map, level) {
    const { scene } = this.editor;
    const looks = {};
    for (const { sign, blueprint } of kindsOf(scene, map)) {
      const opacity = 0.55 + 0.45 * extentOf(blueprint).high;
      looks[sign] = [this.#colours.of(blueprint) ?? '#8a8078', opacity];
    }
    return this.#imageOf(`${map} ${level}`, scene.rows(map, level), looks);
  }

  // Of a ceiling, or of a floor with tiles.
  #tilesOf(map, layer) {
    const { scene } = this.editor;
    const said = scene.value.maps[map][layer];
    const { width, depth } = this.#size;
    const plain = layer === 'ceiling' && said ? Array(depth).fill(kEmpty.repeat(width)) : [];
    const rows = said?.tiles === undefined ? plain : scene.rows(map, layer);
    const looks = {};
    for (const sign of [kEmpty, kOpen, ...Object.keys(said?.legend ?? {})]) {
      const texture = textureOfSign(said, layer, sign);
      if (texture !== null) looks[sign] = [this.#colours.texture(texture) ?? '#5a5148', 1];
    }
    return this.#imageOf(`${map} ${layer}`, rows, looks);
  }

  // One pixel a tile; null without rows. `looks`: colour and opacity of each character that shows.
  // Only rows that have changed since are painted.
  #imageOf(key, rows, looks) {
    if (rows.length === 0) return null;
    const { width, depth } = this.#size;
    const said = JSON.stringify([width, depth, looks]);
    let known = this.#images.get(key);
    if (known?.said !== said) known = { said, rows: [], image: new OffscreenCanvas(width, depth) };
    const context = known.image.getContext('2d');
    let pixels = null; // of each character
    rows.forEach((row, y) => {
      if (row === known.rows[y]) return;
      pixels ??= pixelsOf(looks);
      const line = new ImageData(width, 1);
      const colours = new Uint32Array(line.data.buffer);
      signsOf(row).forEach((sign, x) => (colours[x] = pixels.get(sign) ?? 0));
      context.putImageData(line, 0, y);
    });
    this.#images.set(key, { ...known, rows });
    return known.image;
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

  #things(context, map) {
    const { scene, target, edited } = this.editor;
    const { start } = scene.value;
    const size = Math.max(kLeastIcon, Math.min(kMostIcon, this.scale));
    const chosen = [target?.thing, edited].filter(Boolean).map(String);
    const all = this.#inSight(handlesOf(scene, map, null), size / this.scale);
    const isCrowded = all.length > kMostIcons;
    for (const { path, kind, x, y } of all) {
      if (kind === 'way') continue; // drawn with its links
      const isChosen = chosen.length > 0 && chosen.includes(String(path));
      if (isCrowded && kind === 'object' && !isChosen) {
        context.fillStyle = thingColour(kind);
        context.fillRect(x * this.scale - 1, y * this.scale - 1, 3, 3);
        continue;
      }
      if (kind === 'start') {
        const angle = ((start.heading ?? 0) * Math.PI) / 180;
        this.arrow(context, [x, y], [x + Math.cos(angle), y + Math.sin(angle)], thingColour(kind));
      }
      context.save();
      context.translate(x * this.scale, y * this.scale);
      if (isChosen) halo(context, kind === 'portal' ? 2 * kDot : size);
      if (kind === 'object') this.#object(context, valueAt(scene.value, path), size);
      else if (kind === 'portal') disc(context, kDot, kLinkLooks.portal.colour);
      else {
        context.translate(-size / 2, -size / 2);
        paintThing(context, kind, size);
      }
      context.restore();
    }
  }

  #inSight(things, margin) {
    const [left, top, right, bottom] = this.sight;
    return things.filter(
      ({ x, y }) =>
        x > left - margin && x < right + margin && y > top - margin && y < bottom + margin,
    );
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

// By character, as an image has them.
function pixelsOf(looks) {
  const signs = Object.keys(looks);
  const context = new OffscreenCanvas(signs.length + 1, 1).getContext('2d');
  signs.forEach((sign, x) => {
    [context.fillStyle, context.globalAlpha] = looks[sign];
    context.fillRect(x, 0, 1, 1);
  });
  const { data } = context.getImageData(0, 0, signs.length + 1, 1);
  const colours = new Uint32Array(data.buffer);
  return new Map(signs.map((sign, index) => [sign, colours[index]]));
}
