// Numbers in the text of a figure: dragged to the side, or by keys.
//
// It loads with the few figures that have some, and imports nothing, so that the kit
// stays one file.

const kPixels = 3; // to the side for one step
const kKeys = {
  ArrowRight: 1,
  ArrowUp: 1,
  ArrowLeft: -1,
  ArrowDown: -1,
  PageUp: 10,
  PageDown: -10,
};

// `figure`: {state, change(change)}; `root` holds the text; `valueOf` and `changeOf` are those of
// now.js.
export function listenToNumbers(figure, root, valueOf, changeOf) {
  let held = null; // {pointer, node, x, value}
  const numberAt = ({ target }) => target.closest?.('.fig-scrubbed') ?? null;
  const valueAt = (node) => valueOf(figure.state, node.dataset.field);
  const put = (node, value) => {
    const { field, step } = node.dataset;
    const [least, greatest] = ['min', 'max'].map((end) =>
      Number(node.getAttribute(`aria-value${end}`)),
    );
    const even = Number((Math.round(value / step) * step).toFixed(9));
    figure.change(changeOf(field, Math.max(least, Math.min(greatest, even))));
  };
  root.addEventListener('pointerdown', (event) => {
    const node = numberAt(event);
    if (node === null || event.button !== 0 || !event.isPrimary) return;
    held = { pointer: event.pointerId, node, x: event.clientX, value: valueAt(node) };
    node.setPointerCapture(event.pointerId);
    node.focus({ preventScroll: true });
    event.preventDefault();
  });
  root.addEventListener('pointermove', (event) => {
    if (held?.pointer !== event.pointerId) return;
    const { node, x, value } = held;
    put(node, value + ((event.clientX - x) / kPixels) * node.dataset.step);
  });
  for (const name of ['pointerup', 'pointercancel'])
    root.addEventListener(name, () => (held = null));
  root.addEventListener('keydown', (event) => {
    const node = numberAt(event);
    const by = kKeys[event.key];
    if (node === null || by === undefined) return;
    event.preventDefault();
    put(node, valueAt(node) + by * (event.shiftKey ? 10 : 1) * node.dataset.step);
  });
}
