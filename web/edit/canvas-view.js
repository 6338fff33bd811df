// What the plan and the side view share: a canvas that is panned and zoomed, and pointers that
// become strokes of the editor. A view says what lies where, in units of its own plane.
// Takes a canvas and an editor; gives targets to it. Changes no document.
//
//     class PlanView extends CanvasView {
//       get bounds() {}                  // [left, top, right, bottom], in units
//       find([u, v], event) {}           // a target, or null
//       paint(context) {}                // in CSS pixels from the place 0, 0 on
//       boxOf(from, to) {}               // [left, top, width, height] of two cells
//       grab([u, v], event) {}           // a drag of its own, or null: the tool's
//     }
//     view.draw();   view.fit();
//     view.take(event);                  // true if it is one of its keys
//
// A drag of its own is {move(place, event), end(), cancel()}.
//
// The left button works, the right one removes, or pans when it is dragged; the middle one, or Alt,
// picks. One finger works, two fingers pan and zoom.

import { boxOfCells } from './tools/strokes.js';

const kLeastScale = 1; // CSS pixels a unit
const kSlack = 4; // CSS pixels that a click may move
const kZoom = 1.2; // by a notch of the wheel, or a key
const kKeys = { '+': 1, '=': 1, '-': -1, _: -1 };

export class CanvasView {
  canvas;
  editor;
  scale = 0; // CSS pixels a unit
  #mostScale;
  #left = 0; // of the place 0, 0; CSS pixels
  #top = 0;
  #isDue = false;
  #pointers = new Map();
  #drag = null;

  constructor(canvas, editor, mostScale) {
    this.canvas = canvas;
    this.editor = editor;
    this.#mostScale = mostScale;
    new ResizeObserver(() => this.#resize()).observe(canvas);
    canvas.addEventListener('pointerdown', (event) => this.#down(event));
    canvas.addEventListener('pointermove', (event) => this.#move(event));
    canvas.addEventListener('pointerup', (event) => this.#up(event));
    canvas.addEventListener('pointercancel', (event) => this.#up(event));
    canvas.addEventListener('pointerleave', () => this.#drag === null && editor.point(null));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => this.#wheel(event), { passive: false });
    editor.listen(() => this.draw());
  }

  // Without a pointer, the middle is pointed at.
  aim() {
    this.editor.point(this.find(this.placeAt(this.#middle()), {}));
  }

  grab() {
    return null;
  }

  // Notches of the wheel that the view takes for itself.
  step() {
    return false;
  }

  fit() {
    const [left, top, right, bottom] = this.bounds;
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0 || right === left) return;
    this.scale = this.#clamp(
      Math.min(clientWidth / (right - left + 2), clientHeight / (bottom - top + 2)),
    );
    this.#left = (clientWidth - (left + right) * this.scale) / 2;
    this.#top = (clientHeight - (top + bottom) * this.scale) / 2;
    this.draw();
  }

  draw() {
    if (this.#isDue) return;
    this.#isDue = true;
    requestAnimationFrame(() => {
      this.#isDue = false;
      if (this.canvas.clientWidth === 0) return; // asked here, where the layout is needed anyway
      const context = this.canvas.getContext('2d');
      context.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
      context.clearRect(0, 0, this.canvas.clientWidth, this.canvas.clientHeight);
      context.translate(this.#left, this.#top);
      context.imageSmoothingEnabled = false;
      this.paint(context);
      this.pointed(context);
    });
  }

  // What is in sight, in units: [left, top, right, bottom].
  get sight() {
    const { clientWidth, clientHeight } = this.canvas;
    return [
      -this.#left / this.scale,
      -this.#top / this.scale,
      (clientWidth - this.#left) / this.scale,
      (clientHeight - this.#top) / this.scale,
    ];
  }

  take({ key }) {
    const notches = kKeys[key];
    if (notches !== undefined) this.#zoom(kZoom ** notches, this.#middle());
    else if (key === '0') this.fit();
    return notches !== undefined || key === '0';
  }

  pan(right, down) {
    this.#left += right;
    this.#top += down;
    this.draw();
  }

  placeAt({ clientX, clientY }) {
    const box = this.canvas.getBoundingClientRect();
    return [
      (clientX - box.left - this.#left) / this.scale,
      (clientY - box.top - this.#top) / this.scale,
    ];
  }

  #middle() {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    return { clientX: left + width / 2, clientY: top + height / 2 };
  }

  #clamp(scale) {
    return Math.min(this.#mostScale, Math.max(kLeastScale, scale));
  }

  #resize() {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0) return;
    this.canvas.width = Math.round(clientWidth * devicePixelRatio);
    this.canvas.height = Math.round(clientHeight * devicePixelRatio);
    if (this.scale === 0) this.fit();
    this.draw();
  }

  // ---- Pointers

  #find(event) {
    return this.find(this.placeAt(event), event);
  }

  #down(event) {
    event.preventDefault();
    this.canvas.focus({ preventScroll: true });
    this.canvas.setPointerCapture(event.pointerId);
    this.#pointers.set(event.pointerId, [event.clientX, event.clientY]);
    if (this.#pointers.size > 1) {
      this.cancel();
      return;
    }
    const { button, clientX: x, clientY: y } = event;
    this.#drag = { button, x, y, isMoved: false, own: null };
    if (button !== 0) return;
    const removes = event.ctrlKey || this.editor.removes;
    if (!removes) this.#drag.own = this.grab(this.placeAt(event), event);
    const target = this.#find(event);
    if (target === null || this.#drag.own !== null) return;
    if (event.altKey) this.editor.pick(target);
    else this.editor.press(target, { removes });
  }

  cancel() {
    this.editor.cancel();
    this.#drag?.own?.cancel();
    this.#drag = null;
  }

  #move(event) {
    const before = this.#pointers.get(event.pointerId);
    if (before !== undefined) {
      const [right, down] = [event.clientX - before[0], event.clientY - before[1]];
      if (this.#pointers.size > 1) this.#pinch(event, before);
      else if (this.#drag !== null) this.#dragBy(event, right, down);
      this.#pointers.set(event.pointerId, [event.clientX, event.clientY]);
    }
    this.editor.isWhole = event.shiftKey;
    if (this.#pointers.size < 2 && !this.#drag?.own) this.editor.point(this.#find(event));
  }

  #dragBy(event, right, down) {
    const drag = this.#drag;
    const { clientX, clientY } = event;
    if (Math.hypot(clientX - drag.x, clientY - drag.y) > kSlack) drag.isMoved = true;
    if (!drag.isMoved) return;
    if (drag.own !== null) drag.own.move(this.placeAt(event), event);
    else if (drag.button !== 0) this.pan(right, down);
  }

  // What lies under the two fingers stays there.
  #pinch({ pointerId, clientX, clientY }, before) {
    const [, other] = [...this.#pointers].find(([id]) => id !== pointerId);
    const far = (x, y) => Math.hypot(x - other[0], y - other[1]);
    const [middleX, middleY] = before.map((side, axis) => (side + other[axis]) / 2);
    const factor = far(clientX, clientY) / Math.max(1, far(...before));
    this.#zoom(factor, { clientX: middleX, clientY: middleY });
    this.pan((clientX - before[0]) / 2, (clientY - before[1]) / 2);
  }

  #up(event) {
    this.#pointers.delete(event.pointerId);
    const drag = this.#drag;
    if (drag === null || this.#pointers.size > 0) return;
    this.#drag = null;
    if (drag.own !== null) drag.own.end();
    else if (drag.button === 0) this.editor.release();
    const target = this.#find(event);
    if (target === null || drag.isMoved) return;
    if (drag.button === 1) this.editor.pick(target);
    const isRemoving = drag.button === 2;
    if (!isRemoving && (drag.own === null || event.altKey)) return;
    this.editor.press(target, { removes: isRemoving }); // also a click where a drag could begin
    this.editor.release();
  }

  #wheel(event) {
    event.preventDefault();
    const notches = -Math.sign(event.deltaY || event.deltaX);
    if (this.editor.stroke !== null && this.editor.turn(notches)) return;
    if (!this.step(notches, event)) this.#zoom(kZoom ** notches, event);
  }

  #zoom(factor, { clientX, clientY }) {
    const box = this.canvas.getBoundingClientRect();
    const [x, y] = [clientX - box.left, clientY - box.top];
    const scale = this.#clamp(this.scale * factor);
    this.#left = x - ((x - this.#left) * scale) / this.scale;
    this.#top = y - ((y - this.#top) * scale) / this.scale;
    this.scale = scale;
    this.draw();
  }

  // ---- Drawing

  // The cells that the tool would change.
  pointed(context) {
    const { target, stroke, map, tool } = this.editor;
    if (target === null || target.map !== map) return;
    const at = stroke?.removes ? target.cell : (target.before ?? target.cell);
    if (at === null) return;
    const isBox = stroke !== null && tool.show !== undefined;
    const first = isBox ? (stroke.targets[0].before ?? stroke.targets[0].cell) : at;
    const { from, to } = boxOfCells(first, at);
    context.strokeStyle = stroke?.removes ? '#e3835f' : '#ecc862';
    context.lineWidth = 2;
    context.strokeRect(...this.boxOf(from, to).map((side) => side * this.scale));
  }

  grid(context, columns, lines, [left, top, right, bottom]) {
    const { scale } = this;
    context.strokeStyle = 'rgb(0 0 0 / 0.18)';
    context.lineWidth = 1;
    context.beginPath();
    for (const u of columns) {
      context.moveTo(u * scale, top * scale);
      context.lineTo(u * scale, bottom * scale);
    }
    for (const v of lines) {
      context.moveTo(left * scale, v * scale);
      context.lineTo(right * scale, v * scale);
    }
    context.stroke();
  }

  dot(context, [u, v], colour) {
    const { scale } = this;
    context.beginPath();
    context.arc(u * scale, v * scale, Math.max(2, Math.min(8, scale * 0.28)), 0, 2 * Math.PI);
    context.fillStyle = colour;
    context.fill();
    context.lineWidth = 1.5;
    context.strokeStyle = '#15131c';
    context.stroke();
  }

  arrow(context, from, to, colour) {
    const angle = Math.atan2(to[1] - from[1], to[0] - from[0]);
    const [x, y] = to.map((side) => side * this.scale);
    context.beginPath();
    context.moveTo(...from.map((side) => side * this.scale));
    context.lineTo(x, y);
    for (const side of [-0.5, 0.5]) {
      context.moveTo(x, y);
      context.lineTo(x - 8 * Math.cos(angle + side), y - 8 * Math.sin(angle + side));
    }
    context.strokeStyle = colour;
    context.lineWidth = 2;
    context.stroke();
  }

  // Where the eye stands and looks; `part` of its way lies in the plane.
  eye(context, [u, v], angle, part = 1) {
    const [x, y] = [u * this.scale, v * this.scale];
    const far = Math.max(18, this.scale * 1.5) * part;
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

// One for each number.
export const countTo = (count) => Array.from({ length: count + 1 }, (_, index) => index);
