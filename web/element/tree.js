// The shadow tree of a <ray-caster>, built once, with names for its pieces.
//
//     const tree = buildTree(shadowRoot);
//     tree.cover.hidden = true;
//
// From back to front: picture, poster, cover (a button over the whole picture that starts play),
// progress and messages. steering.js adds thumbs, bar and keys.

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
  const hint = node('span', { class: 'hint', part: 'hint', 'aria-hidden': 'true' });
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
  // Gives the element a width where its container takes the width from the content.
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
