// Everything to steer a <ray-caster> with: bar, keys, thumbs, gamepads. Loaded after the first
// picture, when somebody may soon steer or the bar is wanted (show.js).
//
//     const steering = new Steering(host, show, tree, styles);
//     steering.attributes({controls, keys});      steering.state(state);
//     steering.begin();                           // like a click on the cover

import { Activation } from './activation.js';
import { barActions, toggleFullScreen } from './bar-actions.js';
import { Controls } from './controls.js';
import { Hearing } from './hearing.js';
import { icon } from './icons.js';
import { KeySheet } from './key-sheet.js';
import { node } from './nodes.js';
import { kSheet } from './steering-styles.js';

const kHints = {
  held: 'Escape leaves',
  keys: 'Escape leaves, H shows the keys',
  cursor: 'The mouse position steers; Escape ends it',
};

export class Steering {
  #host;
  #show;
  #tree;
  #activation;
  #controls;
  #keySheet;
  #hearing;

  constructor(host, show, tree, styles) {
    this.#host = host;
    this.#show = show;
    this.#tree = tree;
    styles.add(kSheet);
    tree.leave = node(
      'button',
      {
        class: 'leave',
        part: 'button',
        type: 'button',
        'aria-label': 'Leave the picture',
        hidden: '',
      },
      icon('leave'),
    );
    const bar = node('div', {
      class: 'controls',
      part: 'controls',
      role: 'group',
      'aria-label': 'Controls',
      hidden: '',
    });
    const keys = node('section', {
      class: 'sheet keys',
      role: 'dialog',
      'aria-labelledby': 'keys-title',
      hidden: '',
    });
    tree.progress.before(tree.leave, bar);
    tree.message.before(keys);
    this.#controls = new Controls(bar, barActions(host, show));
    this.#hearing = new Hearing(host, show);
    this.#keySheet = new KeySheet(keys, {
      behind: [tree.stage, tree.cover, bar],
      closed: () => this.focus(),
    });
    this.#activation = new Activation(tree, {
      engine: () => show.engine,
      canBegin: () => show.canPlay && this.#activation.interaction !== 'none',
      changed: (isHeld) => this.#held(isHeld),
    });
  }

  get isHeld() {
    return this.#activation.isHeld;
  }

  attributes({ controls, keys, interaction }) {
    const { sound } = this.#host;
    this.#controls.show(controls?.filter((name) => name !== 'sound' || sound) ?? null);
    this.#hearing.update();
    this.#activation.setKeys(keys);
    this.#activation.setInteraction(interaction);
  }

  state(state) {
    this.#controls.state(state);
    this.#hearing.update();
  }

  begin(options) {
    this.#activation.begin(options);
  }

  resume() {
    this.#activation.resume();
  }

  end() {
    this.#activation.end();
  }

  stop() {
    this.#activation.end();
    this.#keySheet.hide();
  }

  focus(options) {
    (this.#keySheet.isOpen ? this.#keySheet : this.#activation).focus(options);
  }

  takesKey(code) {
    return this.#activation.takesKey(code);
  }

  takeCanvas() {
    this.#activation.takeCanvas();
  }

  // Events of the engine.
  hear(event, value) {
    switch (event) {
      case 'fly':
        this.#activation.flying = value;
        break;
      case 'pointer':
        this.#activation.holdsPointer = value;
        break;
      case 'cursor':
        this.#show.showStatus(value ? kHints.cursor : '', { stays: true });
        break;
      case 'help':
        if (!this.#ask(event)) break;
        this.#host.pause();
        this.#keySheet.open(this.#keys);
        break;
      case 'sound':
        if (this.#host.sound) this.#show.muted = !this.#show.muted;
        break;
      case 'fullscreen':
        if (this.#ask(event)) toggleFullScreen(this.#host, this.#show);
        break;
    }
  }

  // Without sound there is no key for it.
  get #keys() {
    const { keys } = this.#show.engine;
    return this.#host.sound ? keys : keys.filter(({ actions }) => actions[0]?.name !== 'sound');
  }

  // Returns false if the page handles the request itself.
  #ask(request) {
    return this.#show.tell('request', { wish: request }, true);
  }

  #held(isHeld) {
    if (isHeld) this.#keySheet.hide();
    this.#show.showStatus(
      !isHeld || this.#tree.box.classList.contains('touched')
        ? ''
        : this.#activation.keys === 'all'
          ? kHints.keys
          : kHints.held,
    );
    this.#hearing.update(isHeld);
    this.#show.run();
    this.#show.tell('enterchange', { entered: isHeld });
  }
}
