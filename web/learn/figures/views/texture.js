// The texture of a run: the column of texels that the slice uses, and the texel of the picked row.

import { blockName, clamp } from '../geometry.js';
import { at, box, escape, fixed, path, text } from '../markup.js';
import { drawing } from './own.js';

const kFoot = 46;

export function textureView({
  run = (now) => now.run,
  grid = true,
  tallest = 300,
  title,
  ...others
} = {}) {
  const side = (width) => Math.min(width, tallest);
  return drawing({
    title,
    height: (width, now) => heightOf(now, run(now), side(width)) + kFoot,
    ...others,
    label: others.label ?? ((now) => says(now, run(now))),
    markup: (now, { width, id }) => draw(now, run(now), side(width), grid, `${id}-clip`),
  });
}

// What a texture or sprite of the scene looks like: {colour}, or {image, frames}.
function looksOf(now, { texture }) {
  const { scene, image } = now.source;
  const entry = scene?.textures?.[texture] ?? scene?.sprites?.[texture];
  if (entry === undefined) return {};
  if (typeof entry === 'string' && entry.startsWith('#')) return { colour: entry };
  return { image: image(entry.file ?? entry), frames: entry.frames ?? 1 };
}

// The texel of the picked row, or of the nearest row of the run.
export function texelOf(now, run) {
  if (run === null || run.texels.length === 0) return null;
  return isPicked(now, run) ? now.pick.texel : run.texels[0];
}

// Whether the picked pixel shows this run. Runs of one texture may lie over one another.
function isPicked({ pick, row }, { texture, texels, first, last }) {
  if (!pick?.texel || pick.texture !== texture || row < first || row > last) return false;
  const depths = [texels[0].depth, texels.at(-1).depth];
  const near = Math.min(...depths) - 1e-6;
  return pick.depth >= near && pick.depth <= Math.max(...depths) + 1e-6;
}

function heightOf(now, run, side) {
  const texel = texelOf(now, run);
  return texel === null ? 60 : (side * texel.size[1]) / texel.size[0];
}

function says(now, run) {
  const texel = texelOf(now, run);
  return texel === null
    ? 'No texture is picked.'
    : `Texture ${run.texture}: texel ${texel.u}, ${texel.v} of level ${texel.detail}.`;
}

function draw(now, run, side, grid, id) {
  const texel = texelOf(now, run);
  if (texel === null)
    return (
      box(0, 0, side, 60, 'class="fig-ground"') +
      text(12, 35, run === null ? 'This row is open.' : `${blockName(now.slice, run)}: no texture`)
    );
  const [wide, deep] = texel.size;
  const tall = heightOf(now, run, side);
  const unit = side / wide;
  const parts = [box(0, 0, side, tall, 'class="fig-ground"')];
  const { image, frames, colour } = looksOf(now, run);
  if (colour) parts.push(box(0, 0, side, tall, `fill="${escape(colour)}"`));
  if (image) {
    parts.push(
      `<clipPath id="${id}">${box(0, 0, side, tall)}</clipPath>`,
      `<image href="${escape(image)}" x="0" y="0" width="${at(side * frames)}" height="${at(tall)}" preserveAspectRatio="none" class="fig-texture" clip-path="url(#${id})"/>`,
    );
  }
  if (grid && unit >= 3.5) {
    let d = '';
    for (let u = 1; u < wide; ++u) d += `M${(u * unit).toFixed(1)} 0V${tall.toFixed(1)}`;
    for (let v = 1; v < deep; ++v) d += `M0 ${(v * unit).toFixed(1)}H${side}`;
    parts.push(path(d, 'class="fig-texel-grid"'));
  }
  const isUpright = run.what === 'side' || run.what === 'object';
  if (isUpright) {
    // The column, over the texels that its rows use.
    const [first, last] = [run.texels[0].v, run.texels.at(-1).v];
    const top = Math.min(first, last);
    const bottom = Math.max(first, last) + 1;
    const frame = [texel.u * unit - 1, top * unit, unit + 2, (bottom - top) * unit];
    parts.push(
      box(...frame, 'class="fig-texel-column edge"'),
      box(...frame, 'class="fig-texel-column"'),
    );
  }
  const size = Math.max(unit, 7);
  const [x, y] = [
    clamp((texel.u + 0.5) * unit - size / 2, 0, side - size),
    clamp((texel.v + 0.5) * unit - size / 2, 0, tall - size),
  ];
  parts.push(
    box(x, y, size, size, 'class="fig-pixel edge"'),
    box(x, y, size, size, 'class="fig-pixel"'),
  );
  parts.push(
    text(0, tall + 18, `${run.texture}: texel ${texel.u}, ${texel.v}`, 'class="fig-name now"'),
  );
  parts.push(
    text(
      0,
      tall + 37,
      `${texel.detail > 0 ? `level ${texel.detail}: ` : ''}${wide} × ${deep} texels, depth ${fixed(texel.depth)}`,
      'class="soft"',
    ),
  );
  return parts.join('');
}
