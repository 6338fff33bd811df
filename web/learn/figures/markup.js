// Markup of figures: text that the build writes into pages, and that dom.js puts into a live one.
// Attributes stand in double quotation marks; there are no inline styles.

export function escape(text) {
  return String(text).replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/"/g, '&quot;');
}

// A number with a typographic minus and so many digits after the point.
export function fixed(number, digits = 2) {
  if (number === null || number === undefined || Number.isNaN(number)) return '–';
  if (!Number.isFinite(number)) return number < 0 ? '−∞' : '∞';
  const written = number.toFixed(digits);
  return Number(written) === 0 ? written.replace('-', '') : written.replace('-', '−');
}

export function degrees(number, digits = 0) {
  return `${fixed(number, digits)}°`;
}

export function compass(heading) {
  const names = 'east south-east south south-west west north-west north north-east'.split(' ');
  return names[Math.round((((heading % 360) + 360) % 360) / 45) % 8];
}

// ---- Text

export const strong = (text) => `<b>${escape(text)}</b>`;
export const across = (text) => `<span class="across">${escape(text)}</span>`;
export const along = (text) => `<span class="along">${escape(text)}</span>`;
export const swatch = (colour) =>
  `<svg class="fig-swatch" viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><rect width="16" height="16" fill="${escape(colour)}"/></svg>`;
export const hex = (colour) =>
  `#${colour.map((part) => Math.round(part).toString(16).padStart(2, '0')).join('')}`;

// ---- Drawings

// A coordinate: short, and never in exponential notation.
export function at(number) {
  return String(Number(Math.max(-1e4, Math.min(1e4, number)).toFixed(2)));
}

export function text(x, y, content, attributes = '') {
  return `<text x="${at(x)}" y="${at(y)}"${space(attributes)}>${escape(content)}</text>`;
}

export function line(x1, y1, x2, y2, attributes = '') {
  return `<line x1="${at(x1)}" y1="${at(y1)}" x2="${at(x2)}" y2="${at(y2)}"${space(attributes)}/>`;
}

export function box(x, y, width, height, attributes = '') {
  return `<rect x="${at(x)}" y="${at(y)}" width="${at(Math.max(0, width))}" height="${at(Math.max(0, height))}"${space(attributes)}/>`;
}

export function dot(x, y, radius, attributes = '') {
  return `<circle cx="${at(x)}" cy="${at(y)}" r="${at(radius)}"${space(attributes)}/>`;
}

export function path(d, attributes = '') {
  return `<path d="${d}"${space(attributes)}/>`;
}

export function polygon(points, attributes = '') {
  return `<polygon points="${points.map(([x, y]) => `${at(x)},${at(y)}`).join(' ')}"${space(attributes)}/>`;
}

export function group(attributes, parts) {
  return `<g${space(attributes)}>${[parts].flat().join('')}</g>`;
}

// The mark of a crossing: blue and upwards for x, red and downwards for y.
export function mark(x, y, axis, size = 6) {
  const up = axis === 'x' ? 1 : -1;
  return path(
    `M${at(x)} ${at(y - up * size)}L${at(x + size)} ${at(y + up * size * 0.8)}H${at(x - size)}Z`,
    `class="fig-mark ${axis === 'x' ? 'across' : 'along'}"`,
  );
}

// What a handle looks like; `kind` is eye, turn, ray, across or along, `axis` the way it goes.
export function knob(x, y, kind = 'eye', radius = 11, axis = '') {
  const tip = radius + 7;
  const arrows = {
    x: `M${at(x - tip + 4)} ${at(y - 5)}L${at(x - tip)} ${at(y)}l4 5M${at(x + tip - 4)} ${at(y - 5)}L${at(x + tip)} ${at(y)}l-4 5`,
    y: `M${at(x - 5)} ${at(y - tip + 4)}L${at(x)} ${at(y - tip)}l5 4M${at(x - 5)} ${at(y + tip - 4)}L${at(x)} ${at(y + tip)}l5 -4`,
  }[axis];
  return (
    (arrows === undefined ? '' : path(arrows, 'class="fig-knob-arrows"')) +
    dot(x, y, radius, `class="fig-knob ${kind}"`) +
    dot(x, y, radius * 0.36, 'class="fig-knob-dot"')
  );
}

// Text with a width of about this many pixels per character of 13 px.
export const kCharacter = 7.3;

function space(attributes) {
  return attributes === '' ? '' : ` ${attributes}`;
}
