// What a <ray-caster> is made of inside: its shadow tree, built once, with names for its pieces.
//
//     const tree = buildTree(shadowRoot);
//     tree.cover.hidden = true;
//
// From back to front: the picture, the poster, the cover (one button over the whole picture, which
// begins play), progress and messages. steering.js adds thumbs, bar and keys.

import { drawing, kPlay, node } from './nodes.js';

export function buildTree(root) {
  const frame = node('div', { class: 'frame' });
  const stage = node('div', { class: 'stage' }, frame);
  const poster = node('img', {
    class: 'poster',
    part: 'poster',
    alt: '',
    loading: 'lazy',
    hidden: '',
  });
  const hint = node('span', { class: 'hint', 'aria-hidden': 'true' });
  const cover = node(
    'button',
    { class: 'cover', type: 'button' },
    node('span', { class: 'glyph', part: 'button play' }, drawing(kPlay)),
    hint,
  );
  const progress = node('div', {
    class: 'progress',
    role: 'progressbar',
    'aria-label': 'Loading',
    'aria-valuemin': '0',
    'aria-valuemax': '100',
    hidden: '',
  });
  const status = node('p', { class: 'status', part: 'status', role: 'status' });
  const seen = node('p', { class: 'unseen', id: 'seen', 'aria-live': 'off' });
  const message = node('section', { class: 'sheet message', part: 'message', hidden: '' });
  const box = node(
    'div',
    { class: 'box', part: 'box' },
    stage,
    poster,
    cover,
    progress,
    status,
    seen,
    message,
  );
  // It gives the element a width where its place leaves that to what it holds.
  const shape = drawing('');
  shape.setAttribute('class', 'shape');
  root.append(box, shape);
  return {
    root,
    box,
    stage,
    frame,
    poster,
    cover,
    hint,
    progress,
    status,
    seen,
    message,
    canvas: null,
  };
}
