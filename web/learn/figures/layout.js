// The markup of a whole figure, the same at build and in the page.

import { pictureWidth } from './views/picture.js';
import { drawn } from './views/own.js';
import { escape } from './markup.js';
import { sizeOf } from './state.js';

const kGap = 24; // between panels, as in figures.css
export const kStacks = 640; // narrower figures have their panels below each other

const kTallestPicture = 640;

// The widths of a row's panels, in CSS pixels.
export function widthsOf(views, figure, width, ratio = 1) {
  const isPicture = ({ kind }) => kind === 'picture' || kind === 'divider';
  const size = sizeOf(figure);
  if (width < kStacks)
    return views.map((view) => (isPicture(view) ? pictureWidth(size, width, ratio) : width));
  const room = width - kGap * (views.length - 1);
  const shares = views.reduce((sum, { share }) => sum + share, 0);
  const pictures = views.map((view) =>
    isPicture(view)
      ? pictureWidth(size, (room * view.share) / shares, ratio, kTallestPicture)
      : null,
  );
  const taken = pictures.reduce((sum, each) => sum + (each ?? 0), 0);
  const others = views.reduce((sum, view, i) => sum + (pictures[i] === null ? view.share : 0), 0);
  return views.map((view, i) => pictures[i] ?? Math.floor(((room - taken) * view.share) / others));
}

// `body(view, row, place)` writes a panel's content; without `now` only the frame is written.
export function figureMarkup(figure, { name, now = null, body }) {
  const rows = figure.rows
    .map((views, row) => {
      const panels = views.map((view, place) =>
        panelMarkup(view, `${row}.${place}`, now, body(view, row, place)),
      );
      return `<div class="fig-row">${panels.join('')}</div>`;
    })
    .join('');
  return `<div class="fig-rows">${rows}</div><div class="fig-controls">${now === null ? '' : controlsMarkup(figure, name, now)}</div>${saysMarkup(figure, now)}${figure.tools === false ? '' : kTools}<p class="fig-spoken" role="status"></p>`;
}

export function isShown({ when }, state) {
  return when === undefined || state === null || when(state);
}

function panelMarkup(view, key, now, content) {
  const share = Math.max(1, Math.min(8, Math.round(view.share * 2)));
  const hidden = isShown(view, now?.state ?? null) ? '' : ' hidden=""';
  const title = titleOf(view, now);
  const head = title === '' ? '' : `<p class="fig-title">${escape(title)}</p>`;
  return `<div class="fig-panel fig-${view.kind} fig-share-${share}" data-panel="${key}"${hidden}>${head}<div class="fig-body">${content}</div></div>`;
}

export function titleOf({ title = '' }, now) {
  if (typeof title !== 'function') return title ?? '';
  return now === null ? ' ' : title(now.state, now);
}

// What stands in the element .fig-controls.
export function controlsMarkup({ controls = [] }, name, now) {
  return controls
    .map((control, index) => {
      const hidden = isShown(control, now.state) ? '' : ' hidden=""';
      return `<div class="fig-place ${control.kind}" data-control="${index}"${hidden}>${control.markup(now, `${name}-${index}`)}</div>`;
    })
    .join('');
}

function saysMarkup({ says }, now) {
  if (!says) return '';
  return `<p class="fig-says">${now === null ? '' : says(now)}</p>`;
}

const kTools =
  '<div class="fig-tools"><button type="button" data-tool="reset">Reset</button><button type="button" data-tool="link">Copy link</button></div>';

// A panel's content, except pictures: those need an element, or an image.
export function bodyOf(view, now, width, id) {
  if (view.kind === 'panel') return view.markup(now);
  const palette = view.kind === 'paint' ? paletteOf(view, now) : '';
  return palette + drawn(view, now, width, id).markup;
}

// The picture's frame: the marks, in the picture's pixels, over what `inner` draws.
export function frameOf(view, now, [width, height], inner = '') {
  const marks = now === null ? '' : view.markup(now);
  return `<div class="fig-frame">${inner}<svg class="fig-over" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" aria-hidden="true">${marks}</svg></div>`;
}

// The blocks to paint with. The cell itself is chosen on the map.
function paletteOf({ paint }, now) {
  const blocks = paint.blocksOf(now);
  const brush = now.state.brush ?? blocks[0].character;
  const items = blocks.map(({ character, name, colour }) => {
    const fill = colour === null ? 'class="fig-empty"' : `fill="${colour}"`;
    return `<button type="button" class="fig-brush" data-brush="${escape(character)}" aria-pressed="${character === brush}"><svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><rect x="0.5" y="0.5" width="15" height="15" ${fill}/></svg><span>${escape(name)}</span><kbd>${escape(character)}</kbd></button>`;
  });
  return `<div class="fig-palette" role="group" aria-label="Paint with">${items.join('')}</div>`;
}
