// Draws a figure as text, for the build: its markup, its pictures and its numbers.
//
//     const { html, posters, numbers, says } = drawStatic(figure, source, { name, poster });

import { checkFigure } from './check.js';
import { bodyOf, figureMarkup, frameOf, titleOf, widthsOf } from './layout.js';
import { escape, fixed } from './markup.js';
import { apply, makeNow, setOptions } from './now.js';
import { openingState } from './state.js';
import { sidesOf } from './views/divider.js';

const kWidths = [1120, 680]; // of a wide figure, and of one in the text

// Waits for what the figure's own drawing needs.
export async function prepare(figure, source) {
  if (figure.world && source.drawnWorld === undefined)
    source.drawnWorld = await figure.world(source);
}

// The opening moment: the engine is brought to it.
export function openingNow(figure, source, change = {}) {
  if (figure.view) source.look(viewOf(figure.view));
  const state = { ...openingState(figure, source.view), ...change };
  apply(figure, source, state, null);
  return makeNow(figure, source, state);
}

export function drawStatic(
  figure,
  source,
  {
    name,
    poster = (file) => `${file}.png`,
    widths = kWidths,
    wide = false,
    image = (file) => `scenes/${file}`,
  } = {},
) {
  checkFigure({ scene: '', ...figure }); // the source has it
  source.image = image; // beside the page, and not beside the build
  const now = openingNow(figure, source);
  const posters = [];
  const width = widths[wide ? 0 : 1];
  const addPoster = (view, pixels, key) => {
    const file = posters.length === 0 ? name : `${name}-${key}`;
    posters.push({ name: file, pixels });
    const [wideness, tallness] = now.size;
    const alt = view.alt?.(now) ?? titleOf(view, now) ?? '';
    return `<noscript><img src="${escape(poster(file))}" width="${wideness}" height="${tallness}" alt="${escape(alt || 'The picture')}"/></noscript>`;
  };
  const html = figureMarkup(figure, {
    name,
    now,
    body(view, row, place) {
      if (view.kind === 'picture') {
        const image = addPoster(view, pixelsOf(source, view.options, now), `${row}${place}`);
        return frameOf(view, now, now.size, image);
      }
      if (view.kind === 'divider') {
        const image = addPoster(view, splitPixels(view, now), `${row}${place}`);
        return frameOf(view, now, now.size, image);
      }
      const itsWidth = Math.round(widthsOf(figure.rows[row], figure, width)[place]);
      return bodyOf(view, now, itsWidth, `${name}-${row}-${place}`);
    },
  });
  return {
    html: `<div class="fig">${html}</div>`,
    posters,
    numbers: numbersOf(figure, now),
    says: figure.says?.(now) ?? '',
  };
}

export function numbersOf(figure, now) {
  return Object.fromEntries(
    Object.entries(figure.numbers ?? {}).map(([name, of]) => {
      const value = of(now);
      return [name, typeof value === 'number' ? fixed(value) : String(value)];
    }),
  );
}

// The picture of the moment with other options.
function pixelsOf(source, options, now) {
  const more = typeof options === 'function' ? options(now.state) : options;
  if (!more) return source.pixels();
  const before = Object.fromEntries(Object.keys(more).map((name) => [name, source.get(name)]));
  setOptions(source, more, null);
  const pixels = source.pixels();
  setOptions(source, before, null);
  return pixels;
}

// Both sides of a divider in one picture.
function splitPixels(view, now) {
  const { source, width, height, state } = now;
  const [left, right] = sidesOf(view, now).map(({ options, draw }) =>
    draw ? drawnPixels(draw, now) : pixelsOf(source, options, now),
  );
  const data = new Uint8ClampedArray(left.data);
  const from = Math.round(state.split * width);
  for (let y = 0; y < height; ++y) {
    const at = 4 * (y * width + from);
    data.set(right.data.subarray(at, 4 * (y + 1) * width), at);
  }
  return { width, height, data };
}

// What a program of the page draws.
export function drawnPixels(draw, now) {
  const { width, height, source, eye, state } = now;
  const data = new Uint8ClampedArray(4 * width * height);
  for (let i = 3; i < data.length; i += 4) data[i] = 255;
  const picture = { width, height, data, pixels: data };
  draw(picture, source.drawnWorld, { ...eye, fov: Number(source.get('fov')) }, state);
  return picture;
}

export function viewOf(text) {
  if (typeof text === 'object') return text;
  const [x, y, z, heading, look = 0, map] = text.split(',');
  const eye = {
    x: Number(x),
    y: Number(y),
    z: Number(z),
    heading: Number(heading),
    look: Number(look),
  };
  return map === undefined ? eye : { ...eye, map };
}
