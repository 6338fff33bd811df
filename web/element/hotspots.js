// Children of a <ray-caster> attached to places of its world. They follow the view, and hide when
// something covers their place.
//
//     <a data-at="4.5,2,0.6" href="#gate">The gate</a>
//
// The attribute is x,y,z and, if it is not the start's, the name of the map.
//
//     const hotspots = new Hotspots(host, tree, getEngine, warn);    // getEngine() may return null
//     hotspots.place();       // after each picture
//     hotspots.stop();
//
// The children stay in the page's tree; slots in the shadow tree place them over the picture.

import { readPlace } from './place.js';
import { node } from './nodes.js';

const kNearest = 10000; // the largest z-index: nearer hotspots lie on top

export class Hotspots {
  #host;
  #tree;
  #engine;
  #warn;
  #layer = node('div', { class: 'hotspots' });
  #spots = new Map(); // child -> {box, text, place}
  #observer = new MutationObserver(() => this.read());

  constructor(host, tree, engine, warn) {
    this.#host = host;
    this.#tree = tree;
    this.#engine = engine;
    this.#warn = warn;
    tree.cover.after(this.#layer);
    this.#observer.observe(host, {
      childList: true,
      attributes: true,
      attributeFilter: ['data-at'],
      subtree: true,
    });
    this.read();
  }

  read() {
    const children = [...this.#host.querySelectorAll(':scope > [data-at]')];
    const warn = this.#warn();
    for (const [child, { box }] of this.#spots) {
      if (children.includes(child)) continue;
      box.remove();
      this.#spots.delete(child);
    }
    for (const child of children) {
      const text = child.dataset.at;
      let place = null;
      try {
        place = readPlace(text);
      } catch ({ message }) {
        warn('data-at', message);
      }
      const spot = this.#spots.get(child) ?? this.#add(child);
      Object.assign(spot, { text, place });
    }
    this.place();
  }

  place() {
    const engine = this.#engine();
    const { frame } = this.#tree;
    const size = this.#tree.canvas ?? { width: 1, height: 1 };
    for (const side of ['left', 'top', 'width', 'height'])
      if (this.#layer.style[side] !== frame.style[side])
        this.#layer.style[side] = frame.style[side];
    for (const { box, place } of this.#spots.values()) {
      const spot = engine === null || place === null ? null : engine.spot(place, size);
      box.classList.toggle('covered', spot?.isSeen !== true);
      if (spot?.isSeen !== true) continue;
      box.style.left = `${(100 * spot.x) / size.width}%`;
      box.style.top = `${(100 * spot.y) / size.height}%`;
      box.style.zIndex = String(Math.round(kNearest / (1 + spot.depth)));
      box.style.setProperty('--distance', spot.depth.toFixed(2));
    }
  }

  stop() {
    this.#observer.disconnect();
    this.#layer.remove();
  }

  #add(child) {
    const slot = node('slot');
    const box = node('div', { class: 'hotspot covered', part: 'hotspot' }, slot);
    this.#layer.append(box);
    slot.assign?.(child);
    const spot = { box, text: '', place: null };
    this.#spots.set(child, spot);
    return spot;
  }
}
