// The attributes of <ray-caster>: how each is read, and the properties that reflect them.
//
//     const wanted = readAttributes(element);       // throws a Trouble with the code 'address' that names the attribute at fault
//     reflectAttributes(RayCaster.prototype);

import { parseOptions, parseOverlay, parseView } from '../engine/address.js';
import { Trouble } from '../engine/trouble.js';

export const kButtons = ['play', 'reset', 'overlay', 'save', 'share', 'fullscreen'];

const kLargestSide = 4096; // pixels, as the engine's

// Name -> what the property says without the attribute.
const kStandard = {
  scene: '',
  view: '',
  size: 'auto',
  controls: null,
  options: '',
  overlay: '',
  autoplay: false,
  tour: '',
  poster: '',
  loading: 'lazy',
  keys: 'all',
  label: '',
  engine: 'auto',
};

export const kAttributes = Object.keys(kStandard);

export function readAttributes(element) {
  return {
    view: element.view === '' ? null : parseView(element.view),
    size: readSize(element.size),
    controls: readControls(element.controls),
    options: parseOptions(element.options),
    overlay: parseOverlay(element.overlay),
    loading: readChoice('loading', element.loading, ['lazy', 'eager']),
    keys: readChoice('keys', element.keys, ['all', 'move', 'none']),
    engine: readChoice('engine', element.engine, ['auto', 'simd', 'scalar']),
    poster: element.poster,
    label: element.label,
  };
}

// Each attribute as a property of the same name. One that was set before the element was defined is
// taken over by takeEarlyProperties.
export function reflectAttributes(prototype) {
  for (const name of kAttributes) {
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
  for (const name of kAttributes) {
    if (!Object.hasOwn(element, name)) continue;
    const value = element[name];
    delete element[name];
    element[name] = value;
  }
}

function readSize(text) {
  if (text === 'auto') return text;
  const [, width, height] = /^\s*(\d{1,5})\s*x\s*(\d{1,5})\s*$/.exec(text) ?? [];
  const isSide = (side) => Number(side) >= 1 && Number(side) <= kLargestSide;
  if (!isSide(width) || !isSide(height))
    throw misread('size', text, `auto, or WIDTHxHEIGHT in pixels of at most ${kLargestSide}`);
  return `${Number(width)}x${Number(height)}`;
}

function readChoice(name, text, choices) {
  if (!choices.includes(text)) throw misread(name, text, choices.join(', '));
  return text;
}

// null without the attribute, all of them where it is there but empty.
function readControls(text) {
  if (text === null) return null;
  const words = text.split(/\s+/).filter((word) => word !== '');
  for (const word of words) {
    if (!kButtons.includes(word)) throw misread('controls', word, `some of ${kButtons.join(' ')}`);
  }
  return words.length === 0 ? kButtons : kButtons.filter((word) => words.includes(word));
}

function misread(name, found, expected) {
  return new Trouble(
    'An attribute cannot be read',
    `${name}: found "${found}", expected ${expected}`,
    [],
    'address',
  );
}
