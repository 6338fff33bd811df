// Lists mistakes in the page's address, one line each over the picture; the rest of the address is
// used. The lines stay until somebody closes them, plays, or opens another address.
//
//     const problems = new AddressProblems(box, caster);
//     problems.begin(parameters);       of a new address; clears the list
//     problems.add('view', message);
//     nearOf(parameters, scenes)        the scene or tour that was probably meant:
//                                       {name, message, query}, or null

import { nearestName, unknown } from '../engine/nearest-name.js';

const kOfElement = ['view', 'options', 'overlay', 'engine']; // the element warns about these
const kKnown = ['scene', 'tour', ...kOfElement, 'live'];

const nameOf = (file) => file.replace(/\.json$/i, '');

export class AddressProblems {
  #box;
  #list;
  #named = new Set(); // attributes that the address sets

  constructor(box, caster) {
    this.#box = box;
    this.#list = box.querySelector('ul');
    box.querySelector('button').addEventListener('click', () => this.#clear());
    caster.addEventListener('enterchange', () => caster.entered && this.#clear());
    caster.addEventListener('warning', ({ detail: { attribute, message } }) => {
      if (this.#named.has(attribute)) this.add(attribute, message);
    });
  }

  begin(parameters) {
    this.#clear();
    this.#named = new Set(kOfElement.filter((name) => parameters.has(name)));
    for (const [name, value] of parameters) {
      if (!kKnown.includes(name)) {
        // Other parameters may belong to somebody else.
        if (nearestName(name, kKnown) !== null) this.add(name, unknown('name', name, kKnown));
      } else if (value === '' && ['scene', 'tour', 'view'].includes(name)) {
        this.add(name, `Found nothing, expected ${name}=${this.#example(name)}.`);
      } else if (name === 'live' && value !== '1') {
        this.add(name, `Found '${value}', expected live=1.`);
      }
    }
  }

  #example(name) {
    return name === 'view' ? '4.5,2,0.5,90: x, y, height and heading' : 'castle or another name';
  }

  add(name, message) {
    const line = document.createElement('li');
    const place = document.createElement('code');
    place.textContent = name;
    line.append(place, ` ${message.replace(new RegExp(`^${name}: f`), 'F')}`);
    if (name === 'options') {
      const all = Object.assign(document.createElement('a'), {
        href: 'element.html#options',
        textContent: 'All options',
      });
      line.append(' ', all);
    }
    this.#list.append(line);
    this.#box.hidden = false;
  }

  #clear() {
    this.#box.hidden = true;
    this.#list.replaceChildren();
  }
}

// Returns null if the list has that name, or none like it. `query` opens the likely one and keeps
// the rest of the address.
export function nearOf(parameters, scenes) {
  const kind = parameters.get('tour') ? 'tour' : 'scene';
  const word = nameOf(parameters.get(kind) ?? '');
  const names = scenes
    .filter(({ tour }) => kind === 'scene' || tour)
    .map(({ file }) => nameOf(file));
  const near = names.includes(word) ? null : nearestName(word, names);
  if (near === null) return null;
  const query = new URLSearchParams(parameters);
  query.set(kind, near);
  return { name: near, message: unknown(kind, word, names), query: `?${query}` };
}
