// Views of a figure's own.

// HTML. `markup(now)` writes it; clicks on elements with data-change (a change as JSON) make it.
export function panel({ markup, ...options }) {
  return { kind: 'panel', share: 1, ...options, markup };
}

// A drawing in CSS pixels; web/docs/figure-kit.md tells its options.
export function drawing({ height = 260, ...options }) {
  return {
    kind: 'drawing',
    share: 1,
    handles: () => [],
    ...options,
    height: typeof height === 'function' ? height : () => height,
  };
}

// The drawing's whole markup for a width. `id` begins the ids in it: no other drawing has it.
export function drawn(view, now, width, id) {
  const tall = Math.round(view.height(width, now));
  const size = { width, height: tall, id };
  const label = view.label?.(now) ?? view.title ?? '';
  const about =
    label === '' ? 'aria-hidden="true"' : `role="img" aria-label="${now.escape(label)}"`;
  return {
    size,
    markup: `<svg class="fig-svg" viewBox="0 0 ${width} ${tall}" width="${width}" height="${tall}" ${about}>${view.markup(now, size)}</svg>`,
  };
}
