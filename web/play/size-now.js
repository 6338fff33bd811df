// Shows the picture's size now and, if it differs, the size that it last had in motion.
//
//     showSize(caster, output);
//     fullSize(caster)              {width, height} at rest
//     sizeText(caster, size)        "680 × 652 (50 %)"

import { kLargestSide } from '../element/stage.js';

export function showSize(caster, output) {
  let moving = null; // {width, height}
  const show = () => {
    const now = sizeText(caster, caster.picture);
    const then = moving === null ? now : sizeText(caster, moving);
    output.textContent = now === then ? now : `${now}; in motion ${then}`;
  };
  caster.addEventListener('pace', ({ detail: { width, height } }) => {
    moving = { width, height };
    show();
  });
  caster.addEventListener('framechange', show);
  caster.addEventListener('ready', () => {
    moving = null;
    show();
  });
}

// The picture's size at rest: the automatic size draws fewer pixels in motion.
export function fullSize({ size, picture, clientWidth, clientHeight }) {
  if (size !== 'auto') return picture;
  const ratio = window.devicePixelRatio || 1;
  const scale = Math.min(ratio, kLargestSide / Math.max(clientWidth, clientHeight));
  return {
    width: Math.max(1, Math.round(clientWidth * scale)),
    height: Math.max(1, Math.round(clientHeight * scale)),
  };
}

// Adds the share of the screen's pixels across if the picture has the shape of its box.
export function sizeText(caster, { width, height }) {
  const box = caster.clientWidth * (window.devicePixelRatio || 1);
  const boxHeight = caster.clientHeight * (window.devicePixelRatio || 1);
  const fills = Math.abs(width / box - height / boxHeight) < 0.01;
  return `${width} × ${height}${fills ? ` (${Math.round((100 * width) / box)} %)` : ''}`;
}
