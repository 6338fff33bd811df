// Reads the attributes of <ray-caster>, and defines the properties that reflect them.
//
//     const wanted = readAttributes(element, (attribute, message) => {...});
//     reflectAttributes(RayCaster.prototype);
//
// The function is told about bad values; they are ignored.

import { parseOptions, parseOverlay, parseView, wordsOf } from '../engine/address.js';
import { nearestName, unknown } from '../engine/nearest-name.js';
import { kLargestSide } from './stage.js';

export const kButtons = ['play', 'reset', 'overlay', 'sound', 'save', 'share', 'fullscreen'];

const kLeastPercent = 10; // of the box, as a size

const kAllControls = ['true', 'all', 'controls']; // some write them for an attribute without a value
const kNoControls = ['false', 'none'];

// Name -> the property's value without the attribute.
const kStandard = {
  scene: '',
  view: '',
  size: 'auto',
  controls: null,
  options: '',
  overlay: '',
  autoplay: false,
  sound: false,
  tour: '',
  base: '',
  poster: '',
  loading: 'lazy',
  interaction: 'walk',
  keys: 'all',
  label: '',
  syncwith: '',
  engine: 'auto',
};

export const kAttributes = Object.keys(kStandard);

// Attributes with a fixed set of values, the standard one first.
const kChoices = {
  loading: ['lazy', 'eager', 'click'],
  interaction: ['walk', 'look', 'none'],
  keys: ['all', 'move', 'none'],
  engine: ['auto', 'simd', 'scalar'],
};

export function readAttributes(element, warn) {
  warnOfMisspelt(element, warn);
  warnOfSwallowed(element, warn);
  const wanted = {
    view: readView(element.view, warn),
    size: readSize(element.size, warn),
    controls: readControls(element.controls, warn),
    options: parseOptions(element.options),
    overlay: parseOverlay(element.overlay, (message) => warn('overlay', message)),
    syncwith: element.syncwith,
    poster: element.poster,
    label: element.label,
  };
  for (const name of Object.keys(kChoices)) wanted[name] = readChoice(name, element[name], warn);
  return wanted;
}

// Defines a property for each attribute except `scene`, whose property also takes objects.
// takeEarlyProperties() takes over properties that were set before the element was defined.
export function reflectAttributes(prototype) {
  for (const name of kAttributes.filter((one) => one !== 'scene')) {
    const standard = kStandard[name];
    Object.defineProperty(prototype, name, {
      configurable: true,
      enumerable: true,
      get() {
        return standard === false ? this.hasAttribute(name) : (this.getAttribute(name) ?? standard);
      },
      set(value) {
        if (value === null || value === undefined || value === false) this.removeAttribute(name);
        else this.setAttribute(name, value === true ? '' : String(value));
      },
    });
  }
}

export function takeEarlyProperties(element) {
  for (const name of [...kAttributes, 'muted']) {
    if (!Object.hasOwn(element, name)) continue;
    const value = element[name];
    delete element[name];
    element[name] = value;
  }
}

function readView(text, warn) {
  if (text === '') return null;
  try {
    return parseView(text);
  } catch ({ message }) {
    warn('view', message);
    return null;
  }
}

function readSize(text, warn) {
  const { size: standard } = kStandard;
  if (text.trim() === standard) return standard;
  const [, percent] = /^\s*(\d{1,3})\s*%\s*$/.exec(text) ?? [];
  if (percent >= kLeastPercent && percent <= 100) return `${Number(percent)}%`;
  const [, ...sides] = /^\s*(\d{1,5})\s*[x×]\s*(\d{1,5})\s*$/i.exec(text) ?? [];
  const isSide = (side) => side >= 1 && side <= kLargestSide;
  if (sides.length === 2 && sides.every(isSide)) return sides.map(Number).join('x');
  warn(
    'size',
    `Found '${text}', expected auto, WIDTHxHEIGHT of at most ${kLargestSide} pixels each, or ${kLeastPercent}% to 100%.`,
  );
  return standard;
}

function readChoice(name, text, warn) {
  const choices = kChoices[name];
  const word = text.trim().toLowerCase();
  if (choices.includes(word)) return word;
  if (word !== '') warn(name, unknown(`value of ${name}:`, text, choices));
  return choices[0];
}

// Returns null without the attribute, and all controls if it names none.
function readControls(text, warn) {
  if (text === null || kNoControls.includes(text.trim())) return null;
  const named = wordsOf(text).filter((word) => !kAllControls.includes(word));
  for (const word of named)
    if (!kButtons.includes(word)) warn('controls', unknown('control', word, kButtons));
  const known = kButtons.filter((word) => named.includes(word));
  return known.length === 0 ? kButtons : known;
}

// HTML ignores the slash of a self-closed tag: the element then holds all that follows it, to the
// end of its parent. Nobody means to put another one into it, or the parts of a page.
const kParts =
  '> :is(main, nav, article, section, header, footer, aside, form, h1, h2):not([data-at])';

function warnOfSwallowed(element, warn) {
  const { localName: tag, ownerDocument: page } = element;
  if (page.readyState === 'loading') return;
  const has = (selector) => element.querySelector(`:scope ${selector}`) !== null;
  if (has(`${tag}:not([data-at], [data-at] *)`) || (element.nextSibling === null && has(kParts)))
    warn('content', `It holds what follows it: write <${tag} ...></${tag}>, not <${tag} ... />.`);
}

// Warns of unknown attributes that are similar to a known one.
function warnOfMisspelt(element, warn) {
  for (const name of element.getAttributeNames()) {
    if (kAttributes.includes(name) || Reflect.has(element, name) || /[^a-z]/.test(name)) continue;
    if (nearestName(name, kAttributes) !== null)
      warn(name, unknown('attribute', name, kAttributes));
  }
}
