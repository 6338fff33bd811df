// What a <ray-caster> is made of inside: its shadow tree, built once, with names for its pieces.
//
//     const tree = buildTree(shadowRoot);
//     tree.cover.hidden = true;
//
// From back to front: the picture, the poster, the cover (one button over the whole picture, which begins play), thumbs for touch, bars and messages.

import { icon, node } from './nodes.js';
import { adoptStyles } from './styles.js';

export function buildTree(root) {
  const frame = node('div', { class: 'frame' });
  const stage = node('div', { class: 'stage' }, frame);
  const poster = node('img', { class: 'poster', part: 'poster', alt: '', hidden: '' });
  const hint = node('span', { class: 'hint', 'aria-hidden': 'true' });
  const cover = node('button', { class: 'cover', type: 'button' }, node('span', { class: 'glyph', part: 'button play' }, icon('play')), hint);
  const leave = node('button', { class: 'leave', part: 'button', type: 'button', 'aria-label': 'Leave the picture', hidden: '' }, icon('leave'));
  const controls = node('div', { class: 'controls', part: 'controls', role: 'group', 'aria-label': 'Controls', hidden: '' });
  const progress = node('div', { class: 'progress', role: 'progressbar', 'aria-label': 'Loading', 'aria-valuemin': '0', 'aria-valuemax': '100', hidden: '' });
  const status = node('p', { class: 'status', part: 'status', role: 'status' });
  const seen = node('p', { class: 'unseen', id: 'seen', 'aria-live': 'off' });
  const message = node('section', { class: 'sheet message', part: 'message', hidden: '' });
  const keys = node('section', { class: 'sheet keys', role: 'dialog', 'aria-labelledby': 'keys-title', hidden: '' });
  const box = node('div', { class: 'box' }, stage, poster, cover, leave, controls, progress, status, seen, keys, message);
  root.append(box);
  adoptStyles(root);
  return { root, box, stage, frame, poster, cover, hint, leave, controls, progress, status, seen, keys, message, canvas: null };
}
