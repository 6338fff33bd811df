// What the lessons share: numbers as people write them, and figures that follow a picture.
//
//     follow(caster, () => drawPlan(caster.hits(column)));      now if there is a picture, and with every new one

import { escape, putMarkup } from './markup.js';

export const find = (id) => document.getElementById(id);

// With a real minus, and no digits after the point but those that are asked for.
export function fixed(number, digits = 2) {
  return number.toFixed(digits).replace('-', '−');
}

// A coordinate of a drawing: short, and never in the notation of huge numbers.
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

// The marker over a picture of that size: the slice that the figure is about; and what else is
// marked.
export function markColumn(svg, { width, height }, column, more = '') {
  svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
  svg.setAttribute('preserveAspectRatio', 'none');
  const mark =
    box(column - 2, 0, 5, height, 'class="mark-edge"') + box(column, 0, 1, height, 'class="mark"');
  putMarkup(svg, mark + more);
}

// A slider and what is written beside its name.
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
    // Without telling anybody.
    set value(value) {
      if (Number(input.value) !== value) input.value = String(value);
      show();
    },
    set greatest(greatest) {
      input.max = String(greatest);
      show();
    },
    // Over a picture of that many columns; the slider stays where it is when the picture gets
    // another size.
    spread(columns) {
      const share = Number(input.value) / Number(input.max);
      if (columns - 1 === Number(input.max)) return;
      input.max = String(columns - 1);
      input.value = String(Math.round(share * (columns - 1)));
      show();
    },
  };
}

// Draws when the scene is there and after every new picture. What it draws belongs to pictures that
// exist, so nothing is drawn before the first.
export function follow(caster, draw) {
  caster.addEventListener('framechange', () => draw());
  caster.whenReady().then(draw, () => {}); // the element itself says what is wrong
}

// The name that the words of the lessons have for a direction.
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
