// The bar of buttons below the picture.
//
//     const controls = new Controls(bar, actions);
//     controls.show(['play', 'reset']);                             // or null for none
//     controls.state({isReady, isPlaying, hasOverlay, isFullscreen, isMuted});
//
// `actions` maps each button's name to a function.

import { icon } from './icons.js';
import { node } from './nodes.js';

const kNames = {
  play: 'Play',
  reset: 'Back to the start',
  overlay: 'Map and panels',
  sound: 'Sound',
  save: 'Save the picture',
  share: 'Copy the tag',
  fullscreen: 'Full screen',
};
const kAfterSpace = 'overlay'; // this button and those after it stand on the right

export class Controls {
  #buttons = new Map();
  #state = {};

  constructor(bar, actions) {
    this.bar = bar;
    this.actions = actions;
    // Pressing a button leaves the focus, and with it the keys, in the picture.
    bar.addEventListener('mousedown', (event) => event.preventDefault());
  }

  show(names) {
    const wanted = (names ?? []).filter(
      (name) => name !== 'fullscreen' || this.bar.ownerDocument.fullscreenEnabled,
    );
    this.bar.hidden = wanted.length === 0;
    if (wanted.join() === [...this.#buttons.keys()].join()) return;
    this.#buttons = new Map(wanted.map((name) => [name, this.#make(name)]));
    const at = wanted.findIndex(
      (name) => Object.keys(kNames).indexOf(name) >= Object.keys(kNames).indexOf(kAfterSpace),
    );
    const buttons = [...this.#buttons.values()];
    this.bar.replaceChildren(
      ...buttons.slice(0, at < 0 ? buttons.length : at),
      node('span', { class: 'space' }),
      ...(at < 0 ? [] : buttons.slice(at)),
    );
    this.state(this.#state);
  }

  state(state) {
    this.#state = state;
    const { isReady = false, isPlaying = false, hasOverlay = false, isFullscreen = false } = state;
    const { isMuted = false } = state;
    for (const [name, button] of this.#buttons)
      button.disabled = !isReady && name !== 'play' && name !== 'fullscreen';
    this.#set('play', isPlaying ? 'Pause' : 'Play', isPlaying ? 'pause' : 'play');
    this.#set('fullscreen', isFullscreen ? 'Leave full screen' : kNames.fullscreen, 'fullscreen');
    this.#buttons.get('overlay')?.setAttribute('aria-pressed', String(hasOverlay));
    this.#set('sound', isMuted ? 'Sound on' : 'Sound off', isMuted ? 'silence' : 'sound');
  }

  #make(name) {
    const button = node(
      'button',
      {
        type: 'button',
        part: 'button',
        'data-name': name,
        'aria-label': kNames[name],
        title: kNames[name],
      },
      icon(name),
    );
    button.addEventListener('click', () => this.actions[name]());
    return button;
  }

  #set(name, label, shape) {
    const button = this.#buttons.get(name);
    if (button === undefined || button.getAttribute('aria-label') === label) return;
    button.setAttribute('aria-label', label);
    button.title = label;
    button.replaceChildren(icon(shape));
  }
}
