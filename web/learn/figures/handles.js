// Handles of a live figure: sliders of 44 px over the knobs of a drawing.
//
// A handle takes the pointer and, on touch screens, the touch that begins on it; the page scrolls
// from everywhere else. With keys: arrows, with Shift ten times as far, Page Up and Down, Home and
// End; Escape undoes.

const kPageSteps = 10;

// `figure`: {state, now, change(change), restore(state), flush()}. `layer` is the element that
// holds the handles.
export class Handles {
  #figure;
  #layer;
  #nodes = new Map(); // id -> {node, handle}

  constructor(figure, layer) {
    this.#figure = figure;
    this.#layer = layer;
  }

  // `handles` as views give them, in CSS pixels of the layer.
  put(handles) {
    for (const [id, { node }] of this.#nodes) {
      if (handles.some((handle) => handle.id === id)) continue;
      node.remove();
      this.#nodes.delete(id);
    }
    for (const handle of handles) {
      const kept = this.#nodes.get(handle.id) ?? this.#make(handle.id);
      kept.handle = handle;
      const { node } = kept;
      node.style.left = `${handle.x}px`;
      node.style.top = `${handle.y}px`;
      const { label, value, least, greatest, says, axis = 'both' } = handle;
      node.dataset.axis = axis;
      const attributes = {
        'aria-label': label,
        'aria-valuenow': value,
        'aria-valuemin': least,
        'aria-valuemax': greatest,
        'aria-valuetext': says,
        ...(axis === 'y' ? { 'aria-orientation': 'vertical' } : {}),
      };
      for (const [name, text] of Object.entries(attributes))
        if (text !== undefined && node.getAttribute(name) !== String(text))
          node.setAttribute(name, text);
    }
  }

  #make(id) {
    const node = document.createElement('div');
    node.className = 'fig-handle';
    node.dataset.handle = id;
    node.tabIndex = 0;
    node.setAttribute('role', 'slider');
    const kept = { node, handle: null };
    this.#nodes.set(id, kept);
    this.#layer.append(node);
    this.#drag(kept);
    this.#keys(kept);
    return kept;
  }

  #drag(kept) {
    const { node } = kept;
    let held = null; // {pointer, start, dx, dy}
    const end = () => {
      held = null;
      node.classList.remove('held');
    };
    node.addEventListener('pointerdown', (event) => {
      if (held !== null || event.button !== 0 || !event.isPrimary) return;
      this.#figure.flush();
      const box = this.#layer.getBoundingClientRect();
      const { x, y } = kept.handle;
      const { now, state } = this.#figure;
      const point = { x: event.clientX - box.left, y: event.clientY - box.top };
      const { isDirect } = kept.handle; // acts where the pointer is, and from the first touch on
      held = {
        pointer: event.pointerId,
        dx: isDirect ? 0 : point.x - x,
        dy: isDirect ? 0 : point.y - y,
        start: { state, now, point: { x, y } },
      };
      node.setPointerCapture(event.pointerId);
      node.classList.add('held');
      node.focus({ preventScroll: true });
      event.preventDefault();
      event.stopPropagation();
      if (isDirect) this.#figure.change(kept.handle.drag(point, now, held.start, true));
    });
    node.addEventListener('pointermove', (event) => {
      if (held === null || event.pointerId !== held.pointer) return;
      const box = this.#layer.getBoundingClientRect();
      const point = { x: event.clientX - box.left - held.dx, y: event.clientY - box.top - held.dy };
      this.#figure.change(kept.handle.drag(point, this.#figure.now, held.start));
    });
    for (const name of ['pointerup', 'pointercancel', 'lostpointercapture'])
      node.addEventListener(name, (event) => {
        if (event.pointerId === held?.pointer) end();
      });
    node.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || held === null) return;
      const { state } = held.start;
      end();
      this.#figure.restore(state);
      event.preventDefault();
      event.stopPropagation();
    });
  }

  #keys(kept) {
    const { node } = kept;
    let before = null; // the state when the handle got the focus
    node.addEventListener('focus', () => (before = this.#figure.state));
    node.addEventListener('keydown', (event) => {
      if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
      if (event.key === 'Escape') {
        if (before !== null && before !== this.#figure.state) {
          this.#figure.restore(before);
          before = this.#figure.state;
          event.preventDefault();
        }
        return;
      }
      this.#figure.flush();
      const { now } = this.#figure;
      const change = kept.handle.press?.(event.key, now) ?? this.#move(kept.handle, event, now);
      if (change === undefined) return;
      event.preventDefault();
      this.#figure.change(change);
    });
  }

  #move(handle, { key, shiftKey }, now) {
    const by = shiftKey ? kPageSteps : 1;
    const { axis = 'both', least, greatest, value, unit } = handle;
    if (key === 'ArrowRight') return handle.keys(by, 0, now);
    if (key === 'ArrowLeft') return handle.keys(-by, 0, now);
    if (key === 'ArrowDown') return handle.keys(0, by, now);
    if (key === 'ArrowUp') return handle.keys(0, -by, now);
    const along = (steps) =>
      axis === 'y' ? handle.keys(0, -steps, now) : handle.keys(steps, 0, now);
    if (key === 'PageUp') return along(kPageSteps);
    if (key === 'PageDown') return along(-kPageSteps);
    // To an end, where one step of a key is known.
    if (unit === undefined || axis === 'both') return undefined;
    if (key === 'Home') return along((least - value) / unit);
    return key === 'End' ? along((greatest - value) / unit) : undefined;
  }
}

// Calls pick(point) for a tap, and for a mouse that is pressed or drawn over the node.
export function onPick(node, pick) {
  const pointOf = (event) => {
    const box = node.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  let isDrawn = false; // by the mouse
  let isTap = false; // browsers do not all say so in the event click
  node.addEventListener('pointerdown', (event) => {
    isTap = event.pointerType !== 'mouse';
    if (event.pointerType !== 'mouse' || event.button !== 0 || isControl(event)) return;
    isDrawn = true;
    node.setPointerCapture(event.pointerId);
    event.preventDefault();
    pick(pointOf(event), true);
  });
  node.addEventListener('pointermove', (event) => {
    if (isDrawn) pick(pointOf(event), false);
  });
  for (const name of ['pointerup', 'pointercancel'])
    node.addEventListener(name, () => (isDrawn = false));
  node.addEventListener('click', (event) => {
    if (isTap && !isControl(event)) pick(pointOf(event), true);
  });
}

const isControl = ({ target }) => target.closest('.fig-handle, button, input, a') !== null;
