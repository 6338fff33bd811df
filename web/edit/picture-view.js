// The picture as a view of the document: finds what the pointer points at, shows the marks, and
// flies the eye. Takes an element and an editor; gives targets. Changes no document.
//
//     const view = new PictureView(caster, editor, camera);
//     targetOf(pick, scene)                      // from an answer of <ray-caster>.pick()
//
// The left button works, the right one removes, or turns the eye when it is dragged; the middle
// one, or Alt, picks. One finger works, two fingers turn and fly.

import { sizeOf } from './cells.js';
import { handlesOf } from './handles.js';
import { edgeLines } from './mark-lines.js';
import { valueAt } from './things.js';

const kSlack = 4; // CSS pixels that a click may move
const kNear = 14; // CSS pixels from the mark of a thing
const kWheelNotch = 60; // of deltaY, at least
const kNeighbour = {
  north: { y: -1 },
  east: { x: 1 },
  south: { y: 1 },
  west: { x: -1 },
  top: { level: 1 },
  bottom: { level: -1 },
};

export function neighbourOf({ level, x, y }, face) {
  const step = kNeighbour[face] ?? {};
  return { level: level + (step.level ?? 0), x: x + (step.x ?? 0), y: y + (step.y ?? 0) };
}

export function targetOf(pick, scene) {
  if (pick === null || pick.point === null) return null;
  const map = scene.value.maps.findIndex(({ name }) => name === pick.map);
  if (map < 0) return null;
  const target = {
    map,
    mapName: pick.map,
    cell: null,
    before: null,
    face: pick.face,
    point: pick.point,
    thing: pick.object === null ? null : ['maps', map, 'objects', pick.object],
  };
  if (pick.level !== null) {
    const [x, y] = pick.tile;
    target.cell = { level: pick.level, x, y };
    target.before = neighbourOf(target.cell, pick.face);
  } else if (pick.what === 'floor') {
    target.before = { level: 0, x: pick.tile[0], y: pick.tile[1] };
    target.face = 'top';
  } else if (pick.what === 'ceiling') {
    target.before = { level: Math.ceil(pick.point[2]) - 1, x: pick.tile[0], y: pick.tile[1] };
    target.face = 'bottom';
  }
  if (target.before !== null && target.before.level < 0) target.before = null;
  return target;
}

export class PictureView {
  #caster;
  #editor;
  #camera;
  #pointers = new Map(); // id -> {x, y}
  #press = null; // {x, y, button, isTurning, axis, value, sign}
  #isAsked = false;
  #isTurning = false; // the wheel shapes a block, which stays pointed at until the pointer moves
  #place = null;
  #marked = ''; // the lines that are shown, as text
  isOn = true; // not while somebody walks
  #life = new AbortController();

  constructor(caster, editor, camera) {
    this.#caster = caster;
    this.#editor = editor;
    this.#camera = camera;
    const { signal } = this.#life;
    const on = (type, act) => caster.addEventListener(type, act, { signal });
    on('pointerdown', (event) => this.#down(event));
    on('pointermove', (event) => this.#move(event));
    on('pointerup', (event) => this.#up(event));
    on('pointercancel', (event) => this.#up(event));
    on('pointerleave', () => this.#press === null && editor.point(null));
    on('contextmenu', (event) => event.preventDefault());
    on('wheel', (event) => this.#wheel(event));
    on('viewchange', () => {
      if (this.#place === null && this.isOn && camera.isHeld) this.aim();
      else this.#ask();
    });
    editor.listen((what) => what === 'marks' && this.#mark());
  }

  stop() {
    this.#life.abort();
  }

  // Without a pointer, the middle of the picture is pointed at.
  aim() {
    const { left, top, width, height } = this.#caster.getBoundingClientRect();
    this.#editor.point(this.#find(left + width / 2, top + height / 2));
  }

  // Where the pointer is, once more: the world has changed under it.
  refresh() {
    this.#marked = ''; // another world has no marks
    this.#mark();
    this.#ask();
  }

  #down(event) {
    if (!this.isOn) return;
    event.preventDefault();
    this.#caster.focus({ preventScroll: true });
    this.#caster.setPointerCapture(event.pointerId);
    this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (this.#pointers.size > 1) {
      this.#editor.cancel();
      this.#press = null;
      return;
    }
    this.#press = { x: event.clientX, y: event.clientY, button: event.button, isTurning: false };
    this.#place = [event.clientX, event.clientY];
    if (event.button !== 0) return;
    const target = this.#find(event.clientX, event.clientY);
    if (target === null) return;
    if (event.altKey && this.#lift(target)) return;
    if (event.altKey) {
      this.#editor.pick(target);
      return;
    }
    this.#begin(target, event.ctrlKey || this.#editor.removes);
  }

  #begin(target, removes) {
    if (!this.#editor.tool.isFree) this.#bind(target, removes);
    this.#editor.press(target, { removes });
  }

  // With Alt, what stands at a point moves up and down. False for all else.
  #lift(target) {
    const { scene, mapName, tool } = this.#editor;
    const thing = tool.hasThings && target.thing !== null ? valueAt(scene.value, target.thing) : {};
    const { x, y, z = 0 } = thing ?? {};
    if (x === undefined) return false;
    const [here, above] = [z, z + 1].map((height) => this.#caster.project(x, y, height, mapName));
    if (here === null || above === null) return false;
    this.#press.lift = { z, perUnit: above.clientY - here.clientY, from: this.#press.y };
    this.#editor.press(target, { removes: false });
    return true;
  }

  // A stroke stays in the plane where it began: else each block would be put onto the one before.
  #bind({ face, point, cell, before }, removes) {
    const axis = { north: 1, south: 1, east: 0, west: 0, top: 2, bottom: 2 }[face];
    if (axis === undefined) return;
    Object.assign(this.#press, { axis, value: point[axis], face, cell, before, removes });
  }

  #move(event) {
    if (!this.isOn) return;
    const pointer = this.#pointers.get(event.pointerId);
    if (pointer !== undefined && this.#pointers.size > 1) {
      this.#twoFingers(event, pointer);
      return;
    }
    const press = this.#press;
    if (press !== null && press.button === 2) {
      if (Math.hypot(event.clientX - press.x, event.clientY - press.y) > kSlack)
        press.isTurning = true;
      if (press.isTurning && pointer !== undefined)
        this.#camera.turn(event.clientX - pointer.x, event.clientY - pointer.y);
    }
    if (pointer !== undefined) Object.assign(pointer, { x: event.clientX, y: event.clientY });
    this.#place = [event.clientX, event.clientY];
    this.#editor.isWhole = event.shiftKey;
    this.#isTurning = false;
    this.#ask();
  }

  #up(event) {
    this.#pointers.delete(event.pointerId);
    const press = this.#press;
    if (press === null || this.#pointers.size > 0) return;
    if (press.button === 0) {
      this.#point(); // still in the plane of the stroke
      this.#editor.release();
    }
    this.#press = null;
    if (press.isTurning || event.type === 'pointercancel') return;
    const target = this.#find(event.clientX, event.clientY);
    if (target === null) return;
    if (press.button === 1) this.#editor.pick(target);
    if (press.button === 2) {
      this.#editor.press(target, { removes: true });
      this.#editor.release();
    }
    this.#ask();
  }

  #twoFingers(event, pointer) {
    const others = [...this.#pointers].filter(([id]) => id !== event.pointerId);
    const [, other] = others[0];
    const before = Math.hypot(pointer.x - other.x, pointer.y - other.y);
    const after = Math.hypot(event.clientX - other.x, event.clientY - other.y);
    this.#camera.move({ forward: (after - before) / 40 });
    this.#camera.turn((pointer.x - event.clientX) / 2, (pointer.y - event.clientY) / 2);
    Object.assign(pointer, { x: event.clientX, y: event.clientY });
  }

  #wheel(event) {
    if (!this.isOn) return;
    event.preventDefault();
    const notches =
      -Math.sign(event.deltaY) * Math.max(1, Math.round(Math.abs(event.deltaY) / kWheelNotch) / 2);
    if (this.#editor.turn(notches)) {
      this.#isTurning = true;
      return;
    }
    this.#camera.move({ forward: notches });
    this.#ask();
  }

  // Once a frame, however fast the pointer moves.
  #ask() {
    if (this.#isAsked || this.#isTurning || this.#place === null || !this.isOn) return;
    this.#isAsked = true;
    requestAnimationFrame(() => {
      this.#isAsked = false;
      this.#point();
    });
  }

  #point() {
    if (!this.isOn || this.#press?.isTurning || this.#place === null) return;
    const target = this.#find(...this.#place);
    if (target !== null || this.#editor.stroke === null) this.#editor.point(target);
  }

  #find(clientX, clientY) {
    if (this.#caster.currentView === null) return null;
    const { scene, stroke } = this.#editor;
    const lift = this.#press?.lift;
    if (stroke !== null && lift !== undefined)
      return { ...stroke.targets[0], lift: lift.z + (clientY - lift.from) / lift.perUnit };
    if (stroke !== null && this.#press?.axis !== undefined) return this.#inPlane(clientX, clientY);
    const target = targetOf(this.#caster.pick(clientX, clientY), scene);
    return target === null || !this.#editor.tool.hasThings
      ? target
      : { ...target, thing: this.#thingNear(clientX, clientY) ?? target.thing };
  }

  // Objects are seen; of the others the marks are.
  #thingNear(clientX, clientY) {
    const { scene, map, mapName, edited } = this.#editor;
    let [nearest, least] = [null, kNear];
    for (const { path, kind, x, y, z } of handlesOf(scene, map, edited)) {
      const at = kind === 'object' ? null : this.#caster.project(x, y, z, mapName);
      const far = at === null ? Infinity : Math.hypot(at.clientX - clientX, at.clientY - clientY);
      if (far < least) [nearest, least] = [path, far];
    }
    return nearest;
  }

  // Where the ray of a pixel meets the plane of the stroke.
  #inPlane(clientX, clientY) {
    const { axis, value, face } = this.#press;
    const first = this.#editor.stroke.targets[0];
    const ray = this.#rayAt(clientX, clientY);
    if (ray === null) return null;
    const along = (value - ray.from[axis]) / ray.way[axis];
    if (!(along > 0 && along < 200)) return null;
    const point = ray.from.map((from, index) => from + along * ray.way[index]);
    // A little towards the cell, so that the plane itself counts as in it.
    const at = (cell) => {
      if (cell === null) return null;
      const [x, y, level] = point.map(Math.floor);
      return { level, x, y, ...keptOf(cell, axis) };
    };
    return { ...first, point, face, cell: at(first.cell), before: at(first.before) };
  }

  #rayAt(clientX, clientY) {
    const { x, y, z, heading } = this.#caster.currentView;
    const box = this.#caster.getBoundingClientRect();
    const angle = (heading * Math.PI) / 180;
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    // One unit to the right, ten ahead: tells how far the plane of the picture is, and the horizon.
    const mark = this.#caster.project(x + 10 * cos - sin, y + 10 * sin + cos, z);
    if (mark === null) return null;
    const middle = box.left + box.width / 2;
    const distance = 10 * (mark.clientX - middle);
    const right = (clientX - middle) / distance;
    const up = (mark.clientY - clientY) / distance;
    return { from: [x, y, z], way: [cos - right * sin, sin + right * cos, up] };
  }

  #mark() {
    if (!this.isOn || this.#caster.world === null) return;
    const maps = this.#caster.world.maps.map(({ name }) => name);
    const { scene, map, mapName, marks } = this.#editor;
    const all = [...edgeLines(mapName, sizeOf(scene, map)), ...marks];
    const lines = all.filter(({ map }) => maps.includes(map));
    const said = JSON.stringify(lines);
    if (said === this.#marked) return;
    this.#marked = said;
    this.#caster.mark(lines);
  }
}

function keptOf(cell, axis) {
  if (axis === 0) return { x: cell.x };
  return axis === 1 ? { y: cell.y } : { level: cell.level };
}
