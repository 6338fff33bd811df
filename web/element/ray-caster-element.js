// The class of <ray-caster>, its public interface. show.js does the work.

import { readView } from '../engine/address.js';
import { kAttributes, reflectAttributes, takeEarlyProperties } from './attributes.js';
import { checkSize } from './check-size.js';
import { faultOf, orFault } from './faults.js';
import { bringMore } from './later-parts.js';
import { Show } from './show.js';
import { canBeSeen } from './visibility.js';

// Without a document the class can be imported, but not used.
const Base = globalThis.HTMLElement ?? class {};

export class RayCaster extends Base {
  static observedAttributes = kAttributes;

  #show;
  #scene = null; // a scene set as an object
  #source = null;

  constructor() {
    super();
    // Manual: children are shown in several places (hotspots.js), or not at all.
    this.attachShadow({ mode: 'open', slotAssignment: 'manual' });
    this.#show = new Show(this, canBeSeen() ? this.attachInternals() : {});
  }

  // ---- Life

  connectedCallback() {
    takeEarlyProperties(this);
    this.#show.connect();
  }

  disconnectedCallback() {
    this.#show.disconnect();
  }

  // Its presence lets moveBefore() move the element without a restart.
  connectedMoveCallback() {}

  adoptedCallback() {
    this.#show.adopted();
  }

  attributeChangedCallback(name, before, value) {
    if (name === 'scene' && value !== null) this.#scene = null;
    if (before === value || !this.isConnected) return;
    if (name === 'autoplay' && value !== null) this.#show.autoplay();
    this.#show.update();
  }

  focus(options) {
    this.#show.focus(options);
  }

  // ---- Properties

  get scene() {
    return this.#scene ?? this.getAttribute('scene') ?? '';
  }

  set scene(scene) {
    const isObject = typeof scene === 'object' && scene !== null && !(scene instanceof URL);
    this.#scene = isObject ? scene : null;
    if (isObject || (scene ?? false) === false) this.removeAttribute('scene');
    else this.setAttribute('scene', scene);
    if (this.isConnected) this.#show.update();
  }

  get state() {
    return this.#show.state;
  }

  get paused() {
    return this.#show.paused;
  }

  get entered() {
    return this.#show.entered;
  }

  get error() {
    return this.#show.error;
  }

  get source() {
    return this.#source;
  }

  set source(source) {
    this.#source = source ?? null;
    this.#show.update();
  }

  get address() {
    return this.#show.source?.address?.href ?? '';
  }

  get world() {
    const { ready } = this.#show;
    return ready === null ? null : { title: ready.title, maps: ready.maps };
  }

  get memory() {
    return this.#show.engine?.memoryBytes ?? 0;
  }

  get currentView() {
    return this.#ready?.view ?? null;
  }

  get picture() {
    return this.#show.picture;
  }

  get warnings() {
    return this.#show.warnings;
  }

  get player() {
    return this.#ready?.state ?? null;
  }

  get game() {
    return this.#ready?.game ?? null;
  }

  get flying() {
    return this.player?.flying ?? false;
  }

  set flying(flying) {
    this.#engine('flying').flying = flying;
  }

  get replay() {
    return this.#ready?.replayState ?? null;
  }

  get mouse() {
    return this.#show.mouse;
  }

  set mouse(mouse) {
    this.#show.mouse = { ...this.mouse, ...mouse };
  }

  get muted() {
    return this.#show.muted;
  }

  set muted(muted) {
    this.#show.muted = muted;
  }

  get optionList() {
    return this.#ready?.options ?? [];
  }

  get keyList() {
    return this.#ready?.keys ?? [];
  }

  get oldWays() {
    return this.#show.ready === null ? [] : this.#show.engine.oldWays;
  }

  get leftOut() {
    return this.#show.ready === null ? [] : this.#show.engine.leftOut;
  }

  // ---- Methods

  play() {
    this.#show.play();
  }

  pause() {
    this.#show.pause();
  }

  enter(options) {
    this.#show.hold(options);
  }

  reload(options) {
    this.#show.reload(options);
  }

  record(name) {
    this.#engine('record').record(name);
  }

  takeRecording() {
    return this.#engine('takeRecording').takeRecording();
  }

  seek(step) {
    return this.#engine('seek').seek(step);
  }

  reset() {
    this.#engine('reset');
    this.#show.reset();
  }

  step(count = 1, input = {}) {
    this.#engine('step').step(input, count);
  }

  set(name, value) {
    this.#engine('set');
    this.#show.setOption(name, value);
  }

  get(name) {
    return orFault('option', () => this.#engine('get').knownOption(name));
  }

  look(view) {
    return this.#engine('look').look(readView(view));
  }

  land() {
    return this.#engine('land').land();
  }

  timeDrawing(size) {
    const engine = this.#engine('timeDrawing');
    const { width, height } = checkSize('timeDrawing', size ?? this.picture);
    return engine.timeDrawing(width, height);
  }

  async snapshot({ width, height, type = 'image/png', ...others } = {}) {
    const engine = this.#engine('snapshot');
    const { picture } = this;
    const size = { width: width ?? picture.width, height: height ?? picture.height };
    checkSize('snapshot', size);
    const image = engine.drawOnce(size.width, size.height);
    const { encoded } = await bringMore();
    return encoded(image, { type, ...others });
  }

  pixels(size) {
    const engine = this.#engine('pixels');
    const { width, height } = checkSize('pixels', size ?? this.picture);
    return { width, height, data: engine.drawPixels(width, height) };
  }

  hits(columns) {
    const { questions } = this.#engine('hits');
    const { width, height } = this.picture;
    return questions.hits(width, height, checkColumns('hits', columns));
  }

  trace(columns) {
    const { questions } = this.#engine('trace');
    const { width, height } = this.picture;
    return columns === undefined
      ? questions.traceFrame(width, height)
      : questions.trace(width, height, checkColumns('trace', columns));
  }

  cast(from) {
    return this.#engine('cast').questions.cast(from);
  }

  pick(clientX, clientY) {
    const { canvas, questions } = this.#engine('pick');
    const { width, height } = this.picture;
    const box = canvas.getBoundingClientRect();
    return questions.pick(
      width,
      height,
      ((clientX - box.left) * width) / box.width,
      ((clientY - box.top) * height) / box.height,
    );
  }

  project(x, y, z, map) {
    const { canvas, questions } = this.#engine('project');
    const { width, height } = this.picture;
    const point = questions.project(width, height, x, y, z, map);
    if (point === null) return null;
    const box = canvas.getBoundingClientRect();
    return {
      ...point,
      clientX: box.left + (point.x * box.width) / width,
      clientY: box.top + (point.y * box.height) / height,
    };
  }

  cells(map, level) {
    return this.#engine('cells').questions.cells(map, level);
  }

  blueprints(map) {
    return this.#engine('blueprints').questions.blueprints(map);
  }

  tryOldWay(number) {
    return this.#engine('tryOldWay').questions.tryOldWay(number);
  }

  setCell(map, level, x, y, character) {
    this.#engine('setCell').questions.setCells(map, [{ level, x, y, character }]);
  }

  setCells(map, changes) {
    this.#engine('setCells').questions.setCells(map, changes);
  }

  mark(lines) {
    this.#engine('mark').questions.mark(lines);
  }

  async update(scene) {
    this.#engine('update');
    return this.#show.renew(scene);
  }

  async findMistakes(scene) {
    this.#engine('findMistakes');
    return this.#show.renew(scene, true);
  }

  whenReady() {
    return this.#show.whenReady();
  }

  // The engine with a scene in it, or null.
  get #ready() {
    return this.#show.ready === null ? null : this.#show.engine;
  }

  #engine(method) {
    if (this.#ready === null)
      throw faultOf('not-ready', `${method}() was called before the scene had loaded`);
    return this.#ready;
  }
}

// questions.js checks lists and ranges.
function checkColumns(method, columns) {
  if (!Number.isInteger(columns) && (typeof columns !== 'object' || columns === null))
    throw new RangeError(
      `${method}: found column ${columns}, expected a whole number, a list of them, or { first, last }.`,
    );
  return columns;
}

reflectAttributes(RayCaster.prototype);
