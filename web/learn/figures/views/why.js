// Why the picked pixel has its colour, step by step.

import { crossing } from '../geometry.js';
import { escape, fixed, hex, swatch } from '../markup.js';
import { panel } from './own.js';

export function why(options = {}) {
  return panel({ ...options, markup: (now) => list(now) });
}

function list(now) {
  const { pick, column, row } = now;
  const steps = stepsOf(now).map(({ colour, head, says }) => {
    const sample = colour === undefined ? '<span class="fig-swatch"></span>' : swatch(colour);
    return `<li>${sample}<b>${head}</b> <span>${says}</span></li>`;
  });
  const title = `column ${column}, row ${row}: ${pick === null ? 'outside' : nameOf(now, pick)}`;
  return `<p class="fig-why-title">${escape(title)}</p><ol class="fig-why">${steps.join('')}</ol>`;
}

function nameOf(now, pick) {
  if (pick.blueprint)
    return `${pick.blueprint}, ${pick.face === 'top' || pick.face === 'bottom' ? pick.what : `${pick.face} side`}`;
  if (pick.what === 'object') return now.slice.objects[now.run?.object]?.sprite ?? pick.texture;
  return pick.what;
}

export function stepsOf(now) {
  const { pick, slice, source, column, row } = now;
  if (pick === null) return [];
  const key = JSON.stringify({
    ...now.state,
    column: 0,
    row: 0,
    step: null,
    split: 0,
    brush: 0,
    cell: 0,
  });
  const { texel, baked, light, picture } = source.colours(column, row, key);
  const steps = [];
  const { tile } = pick;
  const walked = slice.walk.length;
  const place = slice.walk.findIndex(
    (each) => each.map === pick.map && tile !== null && each.tile.join() === tile.join(),
  );
  if (place > 0) {
    const { axis, border } = crossing(slice, place, now.eyes);
    steps.push({
      head: 'Tile',
      says: `${tile.join(', ')}, the ${ordinal(place + 1)} on the ray, entered through ${axis} = ${border}`,
    });
  } else if (tile !== null)
    steps.push({ head: 'Tile', says: `${tile.join(', ')}${place === 0 ? ', the eye’s own' : ''}` });
  else if (pick.depth === null)
    steps.push({ head: 'Nothing', says: `${walked} tiles walked, and no block in this row` });
  if (pick.portals > 0)
    steps.push({ head: 'Portals', says: `${pick.portals} passed, into ${pick.map}` });
  if (pick.depth !== null) steps.push({ head: 'Depth', says: fixed(pick.depth, 4) });
  if (pick.point !== null)
    steps.push({ head: 'Point', says: pick.point.map((n) => fixed(n, 3)).join(', ') });
  const sample = pick.texel;
  if (sample === null) {
    steps.push({ head: 'Colour', colour: hex(picture), says: `${pick.what}: ${hex(picture)}` });
    return steps;
  }
  const isBaked = sample.baked.some((light) => light !== 256);
  const alone = `${sample.u}, ${sample.v} of ${escape(pick.texture)}, level ${sample.detail} (${sample.size.join(' × ')})`;
  // Of a pixel that shows several things at once, the engine tells only what they are together.
  const isMixed =
    pick.alpha < 255 ||
    pick.reflection !== null ||
    slice.runs.some((run) => run.layer && run.first <= row && row <= run.last);
  if (isMixed) {
    steps.push({ head: 'Texel', says: alone });
    if (isBaked) steps.push({ head: 'Baked light', says: `× ${parts(sample.baked)} ÷ 256` });
    steps.push({ head: 'Light', says: `× ${sample.light} ÷ 256` });
    if (sample.fog > 0) steps.push({ head: 'Fog', says: `${sample.fog} of 255 parts haze` });
  } else {
    // The engine draws without light and fog, but not without the side's own share of light.
    const share = shareOf(now, pick);
    const raw = `${alone}${share === 1 ? `: ${parts(texel)}` : ''}`;
    steps.push({ head: 'Texel', colour: share === 1 ? hex(texel) : undefined, says: raw });
    if (share !== 1)
      steps.push({ head: 'Side', colour: hex(texel), says: `× ${share} = ${parts(texel)}` });
    if (isBaked)
      steps.push({
        head: 'Baked light',
        colour: hex(baked),
        says: `× ${parts(sample.baked)} ÷ 256 = ${parts(baked)}`,
      });
    const all = share === 1 ? '' : ', the side included,';
    steps.push({
      head: 'Light',
      colour: hex(light),
      says: `× ${sample.light} ÷ 256${all} = ${parts(light)}`,
    });
    if (sample.fog > 0)
      steps.push({
        head: 'Fog',
        colour: hex(picture),
        says: `${sample.fog} of 255 parts haze = ${parts(picture)}`,
      });
  }
  if (pick.alpha < 255)
    steps.push({
      head: 'Layer',
      says: `${pick.alpha} of 255 parts; the rest is what stands behind`,
    });
  if (pick.reflection !== null)
    steps.push({
      head: 'Mirror',
      says: `mixed with what it reflects: ${nameOf(now, pick.reflection)}${pick.reflection.depth === null ? '' : ` at depth ${fixed(pick.reflection.depth)}`}`,
    });
  steps.push({
    head: 'Pixel',
    colour: hex(picture),
    says: `${parts(picture)}, which is ${hex(picture)}`,
  });
  return steps;
}

// The factor on the light that a face, the floor, the ceiling or an object has of its own.
function shareOf(now, { map, blueprint, face, what, object }) {
  const { blueprints, objects, ceiling, floor } = now.map(map);
  if (blueprint !== null)
    return [...blueprints.values()].find(({ name }) => name === blueprint)?.faces[face].light ?? 1;
  return { floor, ceiling, object: objects[object] }[what]?.light ?? 1;
}

const parts = (colour) => colour.join(', ');

function ordinal(number) {
  const last = number % 100;
  if (last > 10 && last < 14) return `${number}th`;
  return `${number}${{ 1: 'st', 2: 'nd', 3: 'rd' }[number % 10] ?? 'th'}`;
}
