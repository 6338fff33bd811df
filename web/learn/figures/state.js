// The state of a figure: its opening, changes, and how it is written into the page's address.
//
// A state is a plain object and is never changed: change() makes the next one.

import { clamp } from './geometry.js';

const kFields = { row: null, step: null, columns: null, edits: [], time: 0, split: 0.5 };
const kEye = ['x', 'y', 'z', 'heading', 'look'];

export function sizeOf(figure) {
  return figure.size ?? [480, 300];
}

// `view` is the eye that the engine has after looking along the figure's view.
export function openingState(figure, view) {
  const [width, height] = sizeOf(figure);
  const fields = {};
  for (const control of figure.controls ?? [])
    if (control.field !== undefined && control.opening !== undefined)
      fields[control.field] = control.opening;
  const own = { ...fields, ...figure.state };
  return {
    ...kFields,
    column: width >> 1,
    ...own,
    row: own.row ?? height >> 1,
    eye: { ...view, ...own.eye },
  };
}

// The state after a change; fields of the eye that are left out stay.
export function changed(figure, state, change, now = null) {
  const merged = (before, more) => ({
    ...before,
    ...more,
    eye: { ...before.eye, ...more?.eye },
  });
  let next = merged(state, change);
  if (figure.check) next = merged(next, figure.check(next, now) ?? {});
  const [width, height] = sizeOf(figure);
  const { eye } = next;
  return {
    ...next,
    column: clamp(Math.round(next.column), 0, width - 1),
    row: clamp(Math.round(next.row), 0, height - 1),
    columns: next.columns === null ? null : clamp(Math.round(next.columns), 0, width),
    step: next.step === null ? null : Math.max(0, Math.round(next.step)),
    split: clamp(next.split, 0, 1),
    eye: { ...eye, heading: ((eye.heading % 360) + 360) % 360, look: clamp(eye.look, -4, 4) },
  };
}

export function same(a, b) {
  return a === b || JSON.stringify(a) === JSON.stringify(b);
}

// ---- In the address

// `column:212,eye:4.5_6.2_.5_290`; what is as in the opening state is left out.
export function writeState(state, opening) {
  return Object.keys(opening)
    .filter((field) => !same(state[field], opening[field]))
    .map((field) => `${field}:${written(field, state[field])}`)
    .join(',');
}

// The fields that a text tells; unknown and malformed ones are left out.
export function readState(text, opening) {
  const change = {};
  for (const part of text.split(',')) {
    const colon = part.indexOf(':');
    const field = part.slice(0, colon);
    if (colon < 1 || !Object.hasOwn(opening, field)) continue;
    const value = read(field, part.slice(colon + 1), opening[field]);
    if (value !== undefined) change[field] = value;
  }
  return change;
}

function written(field, value) {
  if (field === 'eye') {
    const { map } = value;
    return [...kEye.map((name) => short(value[name])), encode(map ?? '')].join('_');
  }
  if (field === 'edits')
    return value
      .map(([map, ...place]) => [encode(map ?? ''), ...place].map(encode).join('_'))
      .join('*');
  if (Array.isArray(value)) return value.map(short).join('_');
  if (typeof value === 'number') return short(value);
  return value === null ? '' : encode(value);
}

function read(field, text, opening) {
  if (field === 'eye') {
    const parts = text.split('_');
    const numbers = parts.slice(0, 5).map(Number);
    if (numbers.length < 5 || !numbers.every(Number.isFinite)) return undefined;
    const eye = Object.fromEntries(kEye.map((name, index) => [name, numbers[index]]));
    const map = decode(parts.slice(5).join('_'));
    return map ? { ...eye, map } : eye;
  }
  if (field === 'edits') {
    const edits = text === '' ? [] : text.split('*').map((edit) => edit.split('_').map(decode));
    const isEdit = (edit) => edit.length === 5 && edit.slice(1, 4).every((n) => /^\d+$/.test(n));
    return edits.every(isEdit)
      ? edits.map(([map, level, x, y, sign]) => [decode(map) || null, +level, +x, +y, sign])
      : undefined;
  }
  if (Array.isArray(opening)) {
    const numbers = text.split('_').map(Number);
    return numbers.every(Number.isFinite) ? numbers : undefined;
  }
  if (typeof opening === 'boolean')
    return text === 'true' ? true : text === 'false' ? false : undefined;
  if (typeof opening === 'string') return decode(text);
  if (text === '') return null;
  return Number.isFinite(Number(text)) ? Number(text) : undefined;
}

const short = (number) => (number === null ? '' : String(Number(number.toFixed(4))));

// As encodeURIComponent, and without the characters that separate.
function encode(text) {
  return encodeURIComponent(text).replace(
    /[_*,:]/g,
    (sign) => `%${sign.charCodeAt(0).toString(16).toUpperCase()}`,
  );
}

function decode(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return '';
  }
}
