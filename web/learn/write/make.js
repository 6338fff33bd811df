// Elements of the panel, and its words.

// make('button', { class: 'x', type: 'button', onclick }, 'Run', child)
export function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (typeof value === 'function') element.addEventListener(key.slice(2), value);
    else if (value === true) element.setAttribute(key, '');
    else if (value !== false && value != null) element.setAttribute(key, value);
  }
  element.append(...children);
  return element;
}

export function button(label, onclick, attributes = {}) {
  return make('button', { type: 'button', onclick, ...attributes }, label);
}

// A button that asks before it acts: its first press changes its words.
export function carefulButton(label, question, act) {
  const element = button(label, () => {
    if (element.textContent === question) {
      element.textContent = label;
      act();
    } else element.textContent = question;
  });
  element.addEventListener('blur', () => (element.textContent = label));
  return element;
}

// Text with `names` as code.
export function words(text) {
  const parts = text.split('`');
  return parts.map((part, index) => (index % 2 === 1 ? make('code', {}, part) : part));
}

export const fixed = (number, digits) =>
  typeof number === 'number' && Number.isFinite(number)
    ? number.toFixed(digits).replace('-', '−')
    : String(number ?? '–');

// 99.95 % is never written as 100 %.
export function percent(share) {
  const floored = Math.floor(share * 1e4) / 100;
  return `${share === 1 ? '100' : floored.toFixed(floored < 90 ? 0 : 2)} %`;
}
