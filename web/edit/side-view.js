// The side view: the section through the map along a row or a column of tiles, where the heights of
// blocks, of the ceiling and of things are dragged. A view as the plan is: it gives targets.
// Takes a canvas, an editor and pictures; gives changes of heights to the history.
//
//     const side = new SideView(canvas, editor, colours, pictures, caster);
//     side.show();                 // through what is pointed at, or where the eye is
//     side.move(1);                // the next section, away from the viewer
//     side.turn();                 // from west to east, or from north to south
//
// With the tool Shape the nearest edge of a block is dragged, with Place one that is touched from
// within the block; with Thing objects, lamps and the start. Alt drags finely.

import { CanvasView, countTo } from './canvas-view.js';
import { kEmpty, kMostLevels, sizeOf } from './cells.js';
import { ceilingDrag, edgeDrag, kFine, kStep, snapped, thingDrag } from './height-drags.js';
import { kindOf } from './kinds.js';
import {
  drawBlock,
  drawCeiling,
  drawLabel,
  drawPortal,
  drawSprite,
  line,
} from './section-drawing.js';
import {
  behind,
  blocksIn,
  cellIn,
  countOf,
  edgeAt,
  lengthOf,
  pointOf,
  portalsIn,
  profileOf,
  thingsIn,
} from './section.js';
import { valueAt } from './things.js';

const kMostScale = 240; // CSS pixels a unit
const kGridFrom = 7;
const kBehind = 0.28; // of what lies behind shows through
const kBeside = 0.4; // so of things beside the section, and of blocks that it misses
const kTouch = 7; // CSS pixels from an edge
const kNear = 14; // from a thing
const kGround = 0.35; // units of ground in the picture, below the floor
const kHeadroom = 2; // levels of room above the highest one
const kUnknown = '#8a8078';
const kThingColours = { object: '#8fce7a', lamp: '#ffe9a0', start: '#e3835f' };
const kPortal = '#b58cf0';
const kEdge = '#7fc4e8';

export class SideView extends CanvasView {
  #colours;
  #pictures;
  #caster;
  #section = { axis: 'x', at: 0 };
  #isChosen = false;
  #known = null; // {map, levels}: the blocks of each level, in the section and behind it
  #edge = null; // that the pointer could drag: {along, level, edge, index}, or 'ceiling'

  constructor(canvas, editor, colours, pictures, caster) {
    super(canvas, editor, kMostScale);
    this.#colours = colours;
    this.#pictures = pictures;
    this.#caster = caster;
    editor.scene.listen(({ cells, isWhole }) => {
      if (isWhole) this.#forget();
      else for (const { layer } of cells) delete this.#known?.levels[layer];
      this.draw();
    });
    editor.listen(() => this.editor.map !== this.#known?.map && this.#forget());
    pictures.listen(() => this.draw());
    caster.addEventListener('viewchange', () => this.draw());
  }

  get section() {
    return this.#section;
  }

  // "y 12": the row or column of tiles.
  get name() {
    const { axis, at } = this.#section;
    return `${axis === 'x' ? 'y' : 'x'} ${at}`;
  }

  show() {
    const { target, map } = this.editor;
    const { width, depth } = sizeOf(this.editor.scene, map);
    const cell = target?.cell ?? target?.before ?? null;
    const view = this.#caster.currentView;
    const eye = view?.map === this.editor.mapName ? view : { x: width / 2, y: depth / 2 };
    const { axis } = this.#section;
    if (cell !== null || !this.#isChosen) {
      const at = cell ?? { x: Math.floor(eye.x), y: Math.floor(eye.y) };
      this.#choose({ axis, at: axis === 'x' ? at.y : at.x });
    } else {
      this.#choose(this.#section);
    }
    if (this.scale > 0 && !this.#isChosen) this.fit();
    this.#isChosen = true;
  }

  move(by) {
    const { axis, at } = this.#section;
    this.#choose({ axis, at: at + (axis === 'x' ? -by : by) });
  }

  // Through the same middle of the view.
  turn() {
    const [left, , right] = this.sight;
    const { axis, at } = this.#section;
    const middle = Math.floor((left + right) / 2);
    const center = (left + right) / 2;
    this.#choose({ axis: axis === 'x' ? 'y' : 'x', at: middle });
    this.pan((center - at - 0.5) * this.scale, 0);
  }

  #choose({ axis, at }) {
    const { scene, map } = this.editor;
    const last = countOf(scene, map, { axis }) - 1;
    this.#section = { axis, at: Math.max(0, Math.min(last, at)) };
    this.#forget();
    this.editor.choose({ section: this.#section });
  }

  #forget() {
    this.#known = null;
    this.#edge = null;
    this.draw();
  }

  get #parts() {
    const { scene, map } = this.editor;
    const last = countOf(scene, map, this.#section) - 1;
    this.#section.at = Math.max(0, Math.min(last, this.#section.at)); // maps become smaller
    this.#known ??= { map, levels: [] };
    const { levels } = this.#known;
    for (let level = 0; level < sizeOf(scene, map).levels; ++level)
      levels[level] ??= {
        blocks: blocksIn(scene, map, this.#section, [level]),
        far: behind(scene, map, this.#section, [level]),
      };
    return {
      blocks: levels.flatMap(({ blocks }) => blocks),
      far: levels.flatMap(({ far }) => far),
    };
  }

  get #ceiling() {
    return this.editor.scene.value.maps[this.editor.map].ceiling ?? null;
  }

  // ---- What CanvasView asks

  get bounds() {
    const { scene, map } = this.editor;
    const { levels } = sizeOf(scene, map);
    const height = Math.max(levels, this.#ceiling?.height ?? 0);
    return [0, -height - 1, lengthOf(scene, map, this.#section), kGround];
  }

  boxOf(from, to) {
    const [first, last] = this.#section.axis === 'x' ? [from.x, to.x] : [from.y, to.y];
    return [first, -to.level - 1, last - first + 1, to.level - from.level + 1];
  }

  take(event) {
    const act = {
      ArrowUp: () => this.move(1),
      ArrowDown: () => this.move(-1),
      PageUp: () => this.move(1),
      PageDown: () => this.move(-1),
      ArrowLeft: () => this.pan(this.canvas.clientWidth / 8, 0),
      ArrowRight: () => this.pan(-this.canvas.clientWidth / 8, 0),
    }[event.key];
    act?.();
    return act !== undefined || super.take(event);
  }

  // With Shift the wheel goes from section to section; over an edge Shape takes it.
  step(notches, { shiftKey }) {
    if (shiftKey) this.move(notches);
    return shiftKey || (this.#edge !== null && this.editor.turn(notches));
  }

  // A block is placed where one points, and replaces what stands there, as in the plan.
  find([u, v], event) {
    const { scene, map, mapName, tool } = this.editor;
    const [along, level] = [Math.floor(u), Math.floor(-v)];
    if (along < 0 || along >= lengthOf(scene, map, this.#section) || level >= kMostLevels)
      return null;
    const at = level < 0 ? null : cellIn(this.#section, along, level);
    const found = tool.hasThings ? this.#thingNear(u, -v) : null;
    if (at === null && found === null && !tool.hasThings) return null;
    this.#hover([u, v], event);
    const isFull = at !== null && this.#kindAt(at) !== null;
    return {
      map,
      mapName,
      cell: at,
      before: at,
      face: isFull ? this.#faceAt(at, u - along, -v - level) : 'top',
      point: pointOf(this.#section, u, tool.hasThings ? this.#standing(u, -v) : -v),
      isExact: true, // also its height
      thing: found?.path ?? null,
    };
  }

  #kindAt({ level, x, y }) {
    const { scene, map } = this.editor;
    const sign = scene.sign(map, level, x, y);
    return sign === kEmpty ? null : kindOf(scene, map, sign);
  }

  // The side of the block that is nearest.
  #faceAt(cell, u, height) {
    const { axis } = this.#section;
    const { blueprint } = this.#kindAt(cell);
    const profile = profileOf(blueprint, axis);
    const { edge, distance } = edgeAt(profile, u, height);
    if (this.editor.tool.name !== 'paint') return edge;
    const sides = axis === 'x' ? ['west', 'east'] : ['north', 'south'];
    const [first, last] = [Math.abs(u - profile.from), Math.abs(profile.to - u)];
    if (distance <= Math.min(first, last)) return edge;
    return first < last ? sides[0] : sides[1];
  }

  // What is put a little above a block or the floor stands on it.
  #standing(u, z) {
    const tops = this.#parts.blocks
      .filter(({ along }) => along === Math.floor(u))
      .map(({ level, profile: { top } }) => level + Math.max(...top));
    const ground = Math.max(0, ...tops.filter((top) => top <= z + kStep));
    return z - ground < 4 * kStep ? ground : snapped(z, kStep);
  }

  #thingNear(u, z) {
    const { scene, map } = this.editor;
    let [nearest, least] = [null, kNear / this.scale];
    for (const thing of thingsIn(scene, map, this.#section)) {
      const value = valueAt(scene.value, thing.path);
      const tall = thing.kind === 'object' ? value.height : 0;
      const beside = Math.max(0, thing.z - z, z - thing.z - tall);
      const far = Math.hypot(thing.along - u, beside) + Math.abs(thing.away) / 100;
      if (far < least) [nearest, least] = [thing, far];
    }
    return nearest;
  }

  // ---- Dragging heights

  grab([u, v], { altKey, ctrlKey, pointerType }) {
    const { tool } = this.editor;
    const isShape = tool.name === 'shape';
    if (ctrlKey || (altKey && !isShape && !tool.hasThings)) return null; // it removes, or picks
    if (pointerType === 'touch' && tool.name === 'place') return null; // fingers are too wide
    const drag = tool.hasThings ? this.#grabThing([u, -v]) : this.#grabHeight(u, -v);
    if (drag === null) return null;
    return {
      ...drag,
      move: ([right, down], event) => drag.move([right, -down], event.altKey ? kFine : kStep),
    };
  }

  #grabThing(place) {
    const thing = this.#thingNear(...place);
    if (thing === null) return null;
    this.editor.choose({ edited: thing.path });
    return thingDrag(this.editor, this.#section, thing, place);
  }

  #grabHeight(u, z) {
    const edge = this.#edgeNear(u, z);
    if (edge === null) return null;
    return edge === 'ceiling' ? ceilingDrag(this.editor, z) : edgeDrag(this.editor, edge, z);
  }

  #hover([u, v], event) {
    const { tool, stroke } = this.editor;
    const isFree = stroke === null && event?.pointerType !== 'touch' && !tool.hasThings;
    this.#edge = isFree ? this.#edgeNear(u, -v) : null;
    this.canvas.style.cursor = this.#edge === null ? '' : 'ns-resize';
  }

  #edgeNear(u, z) {
    const { name } = this.editor.tool;
    const isShape = name === 'shape';
    if (!isShape && name !== 'place') return null;
    const cell = cellIn(this.#section, Math.floor(u), Math.floor(z));
    const kind = z < 0 ? null : this.#kindAt(cell);
    if (kind !== null) {
      const height = z - cell.level;
      const profile = profileOf(kind.blueprint, this.#section.axis);
      const { edge, index, distance } = edgeAt(profile, u - Math.floor(u), height);
      const isSlope = Array.isArray(kind.blueprint[edge]);
      const isTouched = distance * this.scale <= kTouch;
      const [low, high] = [Math.min(...profile.bottom), Math.max(...profile.top)];
      const isWithin = height <= high && height >= low;
      if ((isShape || (isTouched && isWithin)) && !(isSlope && index === null))
        return { cell, kind, along: Math.floor(u), edge, index };
    }
    const ceiling = this.#ceiling;
    const isCeiling = ceiling !== null && Math.abs(z - ceiling.height) * this.scale <= kTouch;
    return isCeiling ? 'ceiling' : null;
  }

  // ---- Drawing

  paint(context) {
    const { scene, map } = this.editor;
    const { scale } = this;
    const length = lengthOf(scene, map, this.#section);
    const { levels } = sizeOf(scene, map);
    const { blocks, far } = this.#parts;
    context.fillStyle = this.#colours.floor(map) ?? '#5a5148';
    context.fillRect(0, 0, length * scale, kGround * scale);
    const colourOf = ({ blueprint }) =>
      this.#colours.of(blueprint) ?? blueprint.water?.colour ?? kUnknown;
    for (const block of far) drawBlock(context, scale, block, colourOf(block), kBehind);
    for (const block of blocks)
      drawBlock(context, scale, block, colourOf(block), block.profile.isCut ? 1 : kBeside);
    const lines = countTo(Math.min(kMostLevels, levels + kHeadroom)).map((level) => -level);
    if (scale >= kGridFrom)
      this.grid(context, countTo(length), lines, [0, lines.at(-1), length, 0]);
    drawCeiling(context, scale, scene, map, this.#section, length);
    this.#things(context);
    this.#portals(context);
    this.#eye(context);
    this.#edgeLine(context);
    this.#selected(context);
    this.#numbers(context, lines);
  }

  #things(context) {
    const { scene, map, edited } = this.editor;
    for (const { path, kind, along, z, away } of thingsIn(scene, map, this.#section)) {
      const value = valueAt(scene.value, path);
      context.globalAlpha = Math.abs(away) <= 0.5 ? 1 : kBeside;
      const image = kind === 'object' ? this.#pictures.spriteOf(value.sprite) : null;
      if (image !== null) drawSprite(context, this.scale, image, along, value);
      this.dot(context, [along, -z], kThingColours[kind]);
      if (String(path) === String(edited)) {
        const radius = Math.max(6, Math.min(12, this.scale * 0.4));
        context.beginPath();
        context.arc(along * this.scale, -z * this.scale, radius, 0, 2 * Math.PI);
        context.strokeStyle = '#ffffff';
        context.stroke();
      }
    }
    context.globalAlpha = 1;
  }

  #portals(context) {
    const { scene, map } = this.editor;
    for (const portal of portalsIn(scene, map, this.#section)) {
      const { along, level, exit } = portal;
      drawPortal(context, this.scale, portal);
      if (exit === null) continue;
      const to = [exit.along + 0.5, -exit.level - 0.5];
      this.arrow(context, [along + 0.5, -level - 0.5], to, kPortal);
    }
  }

  #eye(context) {
    const view = this.#caster.currentView;
    if (view === null || view.map !== this.editor.mapName) return;
    const { axis, at } = this.#section;
    const [along, across] = axis === 'x' ? [view.x, view.y] : [view.y, view.x];
    const angle = (view.heading * Math.PI) / 180;
    const ahead = axis === 'x' ? Math.cos(angle) : Math.sin(angle);
    context.globalAlpha = Math.abs(across - at - 0.5) <= 0.5 ? 1 : kBeside;
    this.eye(context, [along, -view.z], ahead >= 0 ? 0 : Math.PI, Math.abs(ahead));
    context.globalAlpha = 1;
  }

  // The outline of what is selected, as far as the section passes through it.
  #selected(context) {
    const { selection, selectedOutline, map } = this.editor;
    if (selection?.map !== map) return;
    const { axis, at } = this.#section;
    const [along, across] = axis === 'x' ? [0, 1] : [1, 0];
    const place = (point) => [point[along] * this.scale, -point[2] * this.scale];
    context.setLineDash([6, 4]);
    context.strokeStyle = kEdge;
    context.lineWidth = 2;
    context.beginPath();
    for (const { from, to } of selectedOutline) {
      if (from[across] !== to[across] || from[across] < at || from[across] > at + 1) continue;
      context.moveTo(...place(from));
      context.lineTo(...place(to));
    }
    context.stroke();
    context.setLineDash([]);
  }

  // The edge that a drag would move.
  #edgeLine(context) {
    const edge = this.#edge;
    if (edge === null) return;
    const { scene, map } = this.editor;
    const to = lengthOf(scene, map, this.#section);
    let points = [
      [0, -this.#ceiling?.height],
      [to, -this.#ceiling?.height],
    ];
    if (edge !== 'ceiling') {
      const kind = this.#kindAt(edge.cell);
      if (kind === null) return;
      const profile = profileOf(kind.blueprint, this.#section.axis);
      points = ['from', 'to'].map((end, index) => [
        edge.along + profile[end],
        -edge.cell.level - profile[edge.edge][index],
      ]);
    }
    line(
      context,
      points.map((point) => point.map((side) => side * this.scale)),
    );
    context.strokeStyle = kEdge;
    context.lineWidth = 3;
    context.stroke();
  }

  // Of the levels at the left, always in sight; what is west or north at the ends.
  #numbers(context, lines) {
    const { scale } = this;
    const [left, top, right] = this.sight;
    const x = left * scale + 4;
    const every = Math.max(1, Math.ceil(16 / scale));
    lines.forEach((v, level) => {
      if (level % every === 0) drawLabel(context, String(level), x, v * scale, 'left');
    });
    const [first, last] = this.#section.axis === 'x' ? ['west', 'east'] : ['north', 'south'];
    const y = top * scale + 20; // below it the page has words
    drawLabel(context, first, x + 24, y, 'left');
    drawLabel(context, last, right * scale - 72, y, 'right');
  }
}
