// Brings a figure to life in a page.
//
//     const scenes = new URL('scenes/', import.meta.url);
//     const figure = mount(element, module, { name: 'rulers', scenes });
//
// The page has loaded ray-caster.js. What the build has drawn into the element stays until the
// scene is there.

import { putMarkup } from './dom.js';
import { drawnPixels, numbersOf, prepare, viewOf } from './draw.js';
import { Handles, onPick } from './handles.js';
import {
  bodyOf,
  controlsMarkup,
  figureMarkup,
  frameOf,
  isShown,
  titleOf,
  widthsOf,
} from './layout.js';
import { apply, changeOf, makeNow, setOptions, valueOf } from './now.js';
import { showImage } from './show-image.js';
import { elementSource } from './source.js';
import { changed, openingState, readState, same, sizeOf, writeState } from './state.js';
import { sidesOf } from './views/divider.js';

const kAddressMilliseconds = 300;
const kSpeakMilliseconds = 700;
const kMarks = { column: 0, row: 0, step: null, split: 0, cell: 0, brush: 0 };
const kCopiedMilliseconds = 2000;

export function mount(element, figure, options = {}) {
  return new LiveFigure(element, figure, options);
}

class LiveFigure {
  #element;
  #figure;
  #options;
  #root;
  #panels = []; // {view, node, body, width, ...}
  #pictures = []; // {panel, side, caster, source, applied, state}
  #main = null;
  #source = null;
  #state = null;
  #opening = null;
  #applied = null; // the state in which the main engine is
  #now = null;
  #frame = 0;
  #timers = new Map();
  #observer = null;
  #stop = new AbortController();

  constructor(element, figure, options) {
    this.#element = element;
    this.#figure = figure;
    this.#options = { name: 'figure', address: true, ...options };
    this.ready = this.#start().catch((error) => {
      this.#tell(error.message);
      throw error;
    });
  }

  get state() {
    return this.#state;
  }

  get now() {
    return this.#now;
  }

  get source() {
    return this.#source;
  }

  // Makes a change, and draws it with the next picture.
  change(change) {
    if (change === null || change === undefined || this.#state === null) return;
    const next = changed(this.#figure, this.#state, change, this.#now);
    if (!same(next, this.#state)) this.restore(next);
  }

  // Goes to a state that was there before.
  restore(state) {
    const before = this.#state;
    this.#state = state;
    if (!this.#bring()) {
      // The eye cannot be there.
      this.#state = { ...state, eye: before.eye };
      this.#bring();
    }
    this.#later('address', kAddressMilliseconds, () => this.#writeAddress());
    this.#redraw();
  }

  reset() {
    this.restore(this.#opening);
  }

  stop() {
    this.#stop.abort();
    this.#observer?.disconnect();
    cancelAnimationFrame(this.#frame);
    for (const timer of this.#timers.values()) clearTimeout(timer);
  }

  // ---- Beginning

  async #start() {
    const figure = this.#figure;
    const built = this.#element.querySelector('.fig');
    this.#root = built ?? this.#makeRoot();
    // What a build has drawn it has checked.
    if (built === null) (await import('./check.js')).checkFigure(figure);
    await customElements.whenDefined('ray-caster');
    this.#findPanels();
    const scene = await this.#makePictures();
    this.#loadWhenNear();
    await this.#loadPainting();
    // All pictures come to life together: a divider must not show one side before the other.
    const casters = [this.#main, ...this.#pictures].map(({ caster }) => caster);
    await Promise.all(casters.filter((caster) => caster !== null).map(isReady));
    this.#source = elementSource(this.#main.caster, {
      scene,
      size: sizeOf(figure),
      address: (file) => new URL(file, this.#base).href,
    });
    await prepare(figure, this.#source);
    if (figure.view) this.#source.look(viewOf(figure.view));
    this.#opening = openingState(figure, this.#source.view);
    this.#state = this.#opening;
    apply(figure, this.#source, this.#state, null);
    this.#source.isUsed = true;
    this.#applied = this.#state;
    this.#now = makeNow(figure, this.#source, this.#state);
    const told = this.#readAddress();
    if (told !== null) {
      this.#state = changed(figure, this.#opening, told, this.#now);
      if (!this.#bring()) {
        this.#state = { ...this.#state, eye: this.#opening.eye };
        this.#bring();
      }
    }
    this.#wire();
    this.#draw();
    this.#observer = new ResizeObserver(() => {
      if (this.#root.clientWidth !== this.#width) this.#redraw();
    });
    this.#observer.observe(this.#root);
    this.#root.classList.add('live');
    return this;
  }

  // Why there is no live figure.
  #tell(message) {
    const node = document.createElement('p');
    node.className = 'fig-fault';
    node.setAttribute('role', 'alert');
    node.textContent = message;
    this.#root.prepend(node);
  }

  #width = 0;
  #hasNumbers = false;
  #base = document.baseURI;

  #makeRoot() {
    const root = document.createElement('div');
    root.className = 'fig';
    this.#element.prepend(root);
    return root;
  }

  #findPanels() {
    const count = this.#figure.rows.flat().length;
    if (this.#root.querySelectorAll('[data-panel]').length !== count) {
      const size = sizeOf(this.#figure);
      putMarkup(
        this.#root,
        figureMarkup(this.#figure, {
          name: this.#options.name,
          body: (view) => (hasFrame(view) ? frameOf(view, null, size) : ''),
        }),
      );
    }
    this.#figure.rows.forEach((views, row) =>
      views.forEach((view, place) => {
        const node = this.#root.querySelector(`[data-panel="${row}.${place}"]`);
        this.#panels.push({ view, row, place, node, body: node.querySelector('.fig-body') });
      }),
    );
  }

  // Puts a <ray-caster> for each picture; a figure without one of its own view has a hidden one.
  // Returns the scene's JSON.
  async #makePictures() {
    const { scene } = this.#figure;
    const isFile = typeof scene === 'string';
    const address = isFile ? new URL(scene, this.#options.scenes ?? document.baseURI) : null;
    this.#base = address ?? this.#options.scenes ?? document.baseURI;
    for (const panel of this.#panels) {
      const { view, body } = panel;
      if (!hasFrame(view)) continue;
      panel.frame = body.querySelector('.fig-frame');
      panel.over = panel.frame.querySelector('.fig-over');
      panel.knobs = layer('fig-knobs', panel.frame);
      panel.handles = new Handles(this, layer('fig-handles', panel.frame));
      for (const place of view.kind === 'divider' ? [0, 1] : [null]) {
        const side = place === null ? null : place === 0 ? view.left : view.right;
        const drawnBy = side?.draw ? this.#makeCanvas(panel, place) : null;
        const caster = drawnBy === null ? this.#makeCaster(panel, place) : null;
        this.#pictures.push({ panel, place, caster, canvas: drawnBy, source: null, applied: null });
      }
    }
    const isPlain = ({ panel, place, caster }) =>
      caster !== null &&
      (place === null
        ? !panel.view.options
        : place === 0 && !panel.view.left.options && !panel.view.left.oldWay);
    this.#main = this.#pictures.find(isPlain) ?? this.#hiddenCaster();
    return isFile ? readScene(scene, address) : scene;
  }

  #makeCaster({ view, frame, over }, place) {
    const caster = document.createElement('ray-caster');
    const [width, height] = sizeOf(this.#figure);
    const { scene, view: eye } = this.#figure;
    caster.setAttribute('size', `${width}x${height}`);
    caster.setAttribute('interaction', view?.walk ? 'walk' : 'none');
    if (eye) caster.setAttribute('view', eye);
    const label = view && titleOf(view, null).trim();
    if (label) caster.setAttribute('label', label);
    if (place !== null) caster.className = place === 0 ? 'left' : 'right';
    if (typeof scene === 'string') caster.setAttribute('scene', this.#base);
    else {
      if (this.#options.scenes) caster.setAttribute('base', this.#base);
      caster.scene = scene;
    }
    if (frame) frame.insertBefore(caster, over);
    return caster;
  }

  #hiddenCaster() {
    const caster = this.#makeCaster({}, null);
    caster.className = 'fig-hidden';
    caster.inert = true;
    caster.setAttribute('aria-hidden', 'true');
    this.#root.append(caster);
    return { caster };
  }

  #makeCanvas({ frame, over }, place) {
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = sizeOf(this.#figure);
    canvas.className = place === 0 ? 'left' : 'right';
    frame.insertBefore(canvas, over);
    return canvas;
  }

  // Each element by itself would load only when it is near, and a figure may be tall.
  #loadWhenNear() {
    const casters = [...this.#pictures.map(({ caster }) => caster), this.#main.caster];
    const watch = new IntersectionObserver(
      (entries) => {
        if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
        watch.disconnect();
        for (const caster of new Set(casters)) caster?.whenReady().catch(() => {}); // it says why
      },
      { rootMargin: '400px' },
    );
    watch.observe(this.#root);
    this.#stop.signal.addEventListener('abort', () => watch.disconnect());
  }

  // Few figures are painted, and few have numbers to drag: what they need loads with them alone.
  async #loadPainting() {
    const panels = this.#panels.filter(({ view }) => view.kind === 'paint');
    if (panels.length === 0) return;
    const { Painting } = await import('./painting.js');
    for (const panel of panels) panel.painting = new Painting(this, panel.view.paint);
  }

  #loadNumbers() {
    if (this.#hasNumbers || this.#root.querySelector('.fig-scrubbed') === null) return;
    this.#hasNumbers = true;
    void import('./numbers.js').then(({ listenToNumbers }) =>
      listenToNumbers(this, this.#root, valueOf, changeOf),
    );
  }

  // ---- The engines

  // Brings all engines to the state. Returns false if the eye cannot be there.
  #bring() {
    const isPlaced = apply(this.#figure, this.#source, this.#state, this.#applied);
    this.#applied = this.#state;
    this.#now = makeNow(this.#figure, this.#source, this.#state);
    return isPlaced;
  }

  // The other pictures of the figure follow the main one.
  #bringOthers() {
    for (const picture of this.#pictures) {
      const { panel, place, caster, canvas } = picture;
      const { view } = panel;
      if (canvas !== null) {
        this.#drawCanvas(picture, place === 0 ? view.left : view.right);
        continue;
      }
      if (caster === this.#main.caster || caster.currentView === null) continue;
      picture.source ??= this.#followWith(caster);
      const more = place === null ? view.options : sidesOf(view, this.#now)[place].options;
      const options = typeof more === 'function' ? more(this.#state) : more;
      const before = picture.applied;
      apply(this.#figure, picture.source, this.#state, before?.state ?? null);
      // What the figure itself sets stays below the picture's own options.
      if (!same(options, before?.options) || before?.state !== this.#state) {
        for (const name of Object.keys(before?.options ?? {}))
          if (!Object.hasOwn(options ?? {}, name)) picture.source.set(name, this.#source.get(name));
        setOptions(picture.source, options ?? {}, null);
      }
      picture.applied = { state: this.#state, options };
    }
  }

  #followWith(caster) {
    const source = elementSource(caster, { size: sizeOf(this.#figure) });
    source.isUsed = true;
    return source;
  }

  // A program may take long: it is not asked again for what only marks the picture.
  #drawCanvas(drawing, { draw }) {
    const { canvas } = drawing;
    const key = JSON.stringify({ ...this.#state, ...kMarks });
    if (drawing.key === key) return;
    drawing.key = key;
    let picture;
    try {
      picture = drawnPixels(draw, this.#now);
    } catch (error) {
      console.warn('The drawing of a figure failed:', error);
      return;
    }
    const { width, height, data } = picture;
    showImage(canvas, new ImageData(data, width, height));
  }

  // ---- Drawing

  #redraw() {
    this.#frame ||= requestAnimationFrame(() => {
      this.#frame = 0;
      this.#draw();
    });
  }

  // Draws at once what waits for the next picture: quick keys find handles as they are then.
  flush() {
    if (this.#frame === 0) return;
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#draw();
  }

  #draw() {
    const figure = this.#figure;
    this.#now = makeNow(figure, this.#source, this.#state);
    const now = this.#now;
    this.#width = this.#root.clientWidth;
    for (const [row, views] of figure.rows.entries()) {
      const shown = views.filter((view) => isShown(view, this.#state));
      const ratio = window.devicePixelRatio || 1;
      const widths = widthsOf(shown, figure, this.#width, ratio);
      for (const panel of this.#panels)
        if (panel.row === row) this.#drawPanel(panel, widths[shown.indexOf(panel.view)]);
    }
    this.#bringOthers();
    this.#drawControls();
    const says = this.#root.querySelector('.fig-says');
    if (says !== null) {
      putMarkup(says, figure.says(now));
      this.#speak(says.textContent);
    }
    this.#loadNumbers();
    this.#options.onNow?.(now, numbersOf(figure, now));
  }

  #drawPanel(panel, width) {
    const { view, node } = panel;
    const now = this.#now;
    node.hidden = width === undefined;
    if (width === undefined) return;
    node.style.flex = 'none';
    node.style.width = `${width}px`;
    const title = node.querySelector('.fig-title');
    if (title !== null) title.textContent = titleOf(view, now);
    if (hasFrame(view)) this.#drawFrame(panel, width);
    else this.#drawBody(panel, Math.round(width));
  }

  #drawFrame(panel, width) {
    const { view, frame, over, knobs, handles } = panel;
    const now = this.#now;
    const [wide, tall] = now.size;
    const size = { width, height: (width * tall) / wide };
    frame.style.width = `${width}px`;
    putMarkup(over, view.markup(now));
    putMarkup(
      knobs,
      `<svg viewBox="0 0 ${size.width} ${size.height}" width="${size.width}" height="${size.height}" aria-hidden="true">${view.knobs(now, size)}</svg>`,
    );
    handles.put(view.handles(now, size));
    if (view.kind !== 'divider') return;
    const share = `${100 * now.state.split}%`;
    frame.style.setProperty('--split', share);
    panel.labels ??= [0, 1].map((place) =>
      layer(`fig-label ${place === 0 ? 'left' : 'right'}`, frame),
    );
    view.labels(now).forEach((label, place) => {
      panel.labels[place].textContent = label;
    });
  }

  #drawBody(panel, width) {
    const { view, body } = panel;
    const now = this.#now;
    panel.content ??= this.#content(body);
    putMarkup(
      panel.content,
      bodyOf(view, now, width, `${this.#options.name}-${panel.row}-${panel.place}`),
    );
    if (view.kind === 'panel') return;
    const svg = panel.content.querySelector('.fig-svg');
    const box = { width, height: Number(svg.getAttribute('height')) };
    panel.box = box;
    panel.layer ??= layer('fig-handles', body);
    panel.layer.style.height = `${box.height}px`;
    panel.handles ??= new Handles(this, panel.layer);
    const cursor = panel.painting ? [panel.painting.cursor(now, box)] : [];
    panel.handles.put([...cursor, ...view.handles(now, box)]);
  }

  #content(body) {
    const content = document.createElement('div');
    content.className = 'fig-content';
    content.append(...body.childNodes);
    body.append(content);
    return content;
  }

  #drawControls() {
    const now = this.#now;
    (this.#figure.controls ?? []).forEach((control, index) => {
      const node = this.#root.querySelector(`[data-control="${index}"]`);
      node.hidden = !isShown(control, this.#state);
      control.show(node, now);
    });
  }

  // ---- Listening

  #wire() {
    const controls = this.#root.querySelector('.fig-controls');
    if (controls.childElementCount === 0)
      putMarkup(controls, controlsMarkup(this.#figure, this.#options.name, this.#now));
    (this.#figure.controls ?? []).forEach((control, index) => {
      const node = this.#root.querySelector(`[data-control="${index}"]`);
      node.addEventListener('input', (event) => {
        const place = [...node.querySelectorAll('input')].indexOf(event.target);
        this.change(control.read(event.target, this.#now, place));
      });
      node.addEventListener('click', (event) => {
        const button = event.target.closest('button');
        if (button !== null) this.change(control.press(button, this.#now));
      });
    });
    for (const panel of this.#panels) this.#wirePanel(panel);
    this.#wireTools();
    if (this.#panels.some(({ view }) => view.walk))
      this.#main.caster.addEventListener('viewchange', () => this.#follow());
  }

  // A visitor walks in the picture.
  #follow() {
    const { view } = this.#source;
    if (same(view, this.#now.eye)) return;
    this.#state = { ...this.#state, eye: view };
    this.#applied = this.#state;
    this.#later('address', kAddressMilliseconds, () => this.#writeAddress());
    this.#redraw();
  }

  #wirePanel(panel) {
    const { view, frame } = panel;
    if (hasFrame(view) && view.point && !view.walk)
      onPick(frame, (point) => {
        const size = { width: frame.clientWidth, height: frame.clientHeight };
        this.change(view.point(this.#now, point, size));
      });
    if (hasFrame(view)) return;
    // The body's markup is made when the panel is first drawn.
    const { body } = panel;
    if (view.click) {
      body.classList.add('picks');
      onPick(body, (point) =>
        this.change(view.click(this.#inDrawing(panel, point), this.#now, panel.box)),
      );
    }
    if (view.kind === 'paint')
      panel.painting.listen(body, onPick, (point) => this.#inDrawing(panel, point));
    if (view.kind === 'panel')
      body.addEventListener('click', ({ target }) => {
        const change = target.closest('[data-change]')?.dataset.change;
        if (change !== undefined) this.change(JSON.parse(change));
      });
  }

  // A point of the body, in the drawing: other things may stand above it.
  #inDrawing({ body, content }, { x, y }) {
    const outer = body.getBoundingClientRect();
    const inner = content.querySelector('.fig-svg').getBoundingClientRect();
    return { x: x + outer.left - inner.left, y: y + outer.top - inner.top };
  }

  #wireTools() {
    this.#root.querySelector('.fig-tools')?.addEventListener('click', ({ target }) => {
      const { tool } = target.dataset;
      if (tool === 'reset') this.reset();
      if (tool === 'link') void this.#copyLink(target);
    });
  }

  // ---- The address

  #readAddress() {
    const { name, address } = this.#options;
    if (address === false) return null;
    const told = parametersOf(location.search).get(name);
    return told === undefined ? null : readState(told, this.#opening);
  }

  #writeAddress() {
    const { name, address } = this.#options;
    if (address === false) return;
    const parameters = parametersOf(location.search);
    const text = writeState(this.#state, this.#opening);
    if (text === '') parameters.delete(name);
    else parameters.set(name, text);
    const query = [...parameters]
      .map(([key, value]) => (value === '' ? key : `${key}=${value}`))
      .join('&');
    const whole = `${location.pathname}${query && `?${query}`}${location.hash}`;
    if (whole !== `${location.pathname}${location.search}${location.hash}`)
      history.replaceState(history.state, '', whole);
  }

  async #copyLink(button) {
    this.#writeAddress();
    const { id } = this.#element;
    const link = `${location.href.replace(/#.*/, '')}${id ? `#${id}` : location.hash}`;
    let says = 'Copied';
    try {
      await navigator.clipboard.writeText(link);
    } catch {
      says = 'It is in the address bar';
    }
    button.textContent = says;
    this.#later('copied', kCopiedMilliseconds, () => (button.textContent = 'Copy link'));
  }

  // ---- Small things

  // Told to screen readers once the hand rests.
  #speak(text) {
    const node = this.#root.querySelector('.fig-spoken');
    if (node === null || node.dataset.last === text) return;
    const isFirst = node.dataset.last === undefined;
    node.dataset.last = text;
    if (!isFirst) this.#later('speak', kSpeakMilliseconds, () => (node.textContent = text));
  }

  #later(name, milliseconds, act) {
    clearTimeout(this.#timers.get(name));
    this.#timers.set(name, setTimeout(act, milliseconds));
  }
}

async function readScene(name, address) {
  const response = await fetch(address).catch(({ message }) => ({ ok: false, status: message }));
  const fault = (found) =>
    new Error(
      `scene: ${address} ${found}.${/\.json$/.test(name) ? '' : ` Did you mean '${name}.json'?`}`,
    );
  if (!response.ok) throw fault(`could not be fetched: ${response.status}`);
  return response.json().catch(({ message }) => {
    throw fault(`is not JSON: ${message}`);
  });
}

const hasFrame = ({ kind }) => kind === 'picture' || kind === 'divider';

function layer(name, parent) {
  const node = document.createElement('div');
  node.className = name;
  parent.append(node);
  return node;
}

// Does not make the element load: it does so when it comes near the window.
function isReady(caster) {
  if (caster.currentView !== null) return Promise.resolve();
  return new Promise((resolve) => caster.addEventListener('ready', resolve, { once: true }));
}

// The parameters of a query as they are written.
function parametersOf(query) {
  return new Map(
    query
      .replace(/^\?/, '')
      .split('&')
      .filter((part) => part !== '')
      .map((part) => {
        const at = part.indexOf('=');
        return at < 0 ? [part, ''] : [part.slice(0, at), part.slice(at + 1)];
      }),
  );
}
