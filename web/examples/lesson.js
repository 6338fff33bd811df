// Shared by the lessons: readable numbers, and figures that follow a picture.
//
//     follow(caster, () => drawPlan(caster.hits(column)));      draws for every picture

import { escape, putMarkup } from './markup.js';

export const find = (id) => document.getElementById(id);

// Writes a number with a typographic minus and so many digits after the point.
export function fixed(number, digits = 2) {
  return number.toFixed(digits).replace('-', '−');
}

// Writes a coordinate of a drawing: short, and never in exponential notation.
export function at(number) {
  return String(Number(Math.max(-1e4, Math.min(1e4, number)).toFixed(3)));
}

export function text(x, y, content, attributes = '') {
  return `<text x="${at(x)}" y="${at(y)}" ${attributes}>${escape(content)}</text>`;
}

export function line(x1, y1, x2, y2, attributes = '') {
  return `<line x1="${at(x1)}" y1="${at(y1)}" x2="${at(x2)}" y2="${at(y2)}" ${attributes}/>`;
}

export function box(x, y, width, height, attributes = '') {
  return `<rect x="${at(x)}" y="${at(y)}" width="${at(Math.max(0, width))}" height="${at(Math.max(0, height))}" ${attributes}/>`;
}

export function dot(x, y, radius, attributes = '') {
  return `<circle cx="${at(x)}" cy="${at(y)}" r="${at(radius)}" ${attributes}/>`;
}

// Marks the slice of a figure over a picture of that size, and whatever `more` adds.
export function markColumn(svg, { width, height }, column, more = '') {
  svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
  svg.setAttribute('preserveAspectRatio', 'none');
  const mark =
    box(column - 2, 0, 5, height, 'class="mark-edge"') + box(column, 0, 1, height, 'class="mark"');
  putMarkup(svg, mark + more);
}

// A slider whose value is written beside its name.
export function slider(id, write, onChange) {
  const input = find(id);
  const output = document.querySelector(`output[for="${id}"]`);
  const show = () => {
    output.textContent = write(Number(input.value));
    input.setAttribute('aria-valuetext', output.textContent);
  };
  input.addEventListener('input', () => {
    show();
    onChange(Number(input.value));
  });
  show();
  return {
    get value() {
      return Number(input.value);
    },
    // Does not call onChange.
    set value(value) {
      if (Number(input.value) !== value) input.value = String(value);
      show();
    },
    set greatest(greatest) {
      input.max = String(greatest);
      show();
    },
    // Sets the number of columns. The slider keeps its relative place when the picture changes
    // size.
    spread(columns) {
      const share = Number(input.value) / Number(input.max);
      if (columns - 1 === Number(input.max)) return;
      input.max = String(columns - 1);
      input.value = String(Math.round(share * (columns - 1)));
      show();
    },
  };
}

// Calls draw() once the scene is ready and after every new picture.
export function follow(caster, draw) {
  caster.addEventListener('framechange', () => draw());
  caster.whenReady().then(draw, () => {}); // the element itself says what is wrong
}

// The name of a direction in the lessons' text.
export function compass(heading) {
  const names = [
    'east',
    'south-east',
    'south',
    'south-west',
    'west',
    'north-west',
    'north',
    'north-east',
  ];
  return names[Math.round((((heading % 360) + 360) % 360) / 45) % 8];
}
