// The first steps in the editor, four of them, each shown until it is done or passed over.
// Takes the page's parts and tells what they do; changes no document, and knows no tool.
//
//     const tour = new Tour(card, { scene, camera: caster, isWalking, find: byId });
//     tour.begin();            // from the first step
//     tour.begin({ once: true })   // not if somebody has seen it in this browser
//
// A step that speaks of a button puts data-told on it, for a ring around it.

import { isTouch, listenToFingers } from './fingers.js';

const kSeen = 'slicecast edit tour';
const kFar = 1.5; // units that one flies before it counts
const kPause = 900; // milliseconds between a step that is done and the next

const kSteps = [
  {
    title: 'Put a block',
    text: () =>
      isTouch()
        ? 'Choose one below the picture, and tap where it is to stand. A drag puts a row, Remove takes away, and Undo is above.'
        : 'Choose one below the picture, and click where it is to stand. A drag puts a row, the right button removes, and Ctrl+Z undoes.',
    isDone: ({ scene, begun }) => scene.text !== begun.text,
  },
  {
    title: 'Look around',
    text: () =>
      isTouch()
        ? 'Two fingers turn the view; pull them apart to fly ahead.'
        : 'Drag with the right button to turn, and fly with W A S D. Space rises, C sinks.',
    isDone({ caster, begun }) {
      const { x, y, z, heading } = caster.currentView;
      const turned = Math.abs(((heading - begun.view.heading + 540) % 360) - 180);
      return turned > 25 || Math.hypot(x - begun.view.x, y - begun.view.y, z - begun.view.z) > kFar;
    },
  },
  {
    title: 'Walk in it',
    text: () =>
      isTouch()
        ? 'Press Walk, above. You begin where you are; Back to editing ends it.'
        : 'Press Walk, or Tab. You begin where you are; Escape brings you back.',
    ring: 'walk',
    isDone: ({ isWalking }) => isWalking(),
  },
  {
    title: 'Show it to somebody',
    text: () =>
      'Save and share has a link that holds the whole world. Open has other worlds to begin with, and all the shipped ones to take apart.',
    ring: 'open-share',
    isDone: ({ find }) => find('share').open,
  },
];

export class Tour {
  #card;
  #parts; // {scene, caster, isWalking, find}
  #step = 0;
  #begun = null; // {text, view} when the step began
  #timer = 0;

  constructor(card, parts) {
    this.#card = card;
    this.#parts = parts;
    card.querySelector('[data-next]').addEventListener('click', () => this.#go(this.#step + 1));
    card.querySelector('[data-skip]').addEventListener('click', () => this.#end());
    parts.scene.listen(() => this.look());
    listenToFingers(() => this.#tell());
    parts.caster.addEventListener('viewchange', () => this.look());
  }

  begin({ once = false } = {}) {
    if (once && isSeen()) return;
    this.#go(0);
  }

  // Is the step done? To be called where something happens that the tour may speak of.
  look() {
    if (this.#begun === null || !kSteps[this.#step].isDone({ ...this.#parts, begun: this.#begun }))
      return;
    this.#begun = null;
    this.#card.dataset.state = 'done';
    this.#timer = setTimeout(() => this.#go(this.#step + 1), kPause);
  }

  #go(step) {
    clearTimeout(this.#timer);
    const { scene, caster, find } = this.#parts;
    this.#ring(null);
    if (step === kSteps.length) {
      this.#end();
      return;
    }
    this.#step = step;
    this.#begun = { text: scene.text, view: caster.currentView };
    const { title, ring } = kSteps[step];
    const part = (name) => this.#card.querySelector(`[data-${name}]`);
    part('count').textContent = `${step + 1} of ${kSteps.length}`;
    part('title').textContent = title;
    this.#tell();
    part('next').textContent = step === kSteps.length - 1 ? 'Done' : 'Next';
    this.#ring(ring === undefined ? null : find(ring));
    this.#card.dataset.state = 'shown';
    this.#card.hidden = false;
  }

  #tell() {
    this.#card.querySelector('[data-text]').textContent = kSteps[this.#step].text();
  }

  #end() {
    clearTimeout(this.#timer);
    this.#begun = null;
    this.#ring(null);
    this.#card.hidden = true;
    try {
      localStorage.setItem(kSeen, 'yes');
    } catch {
      // It comes again the next time.
    }
  }

  #ring(element) {
    for (const ringed of document.querySelectorAll('[data-told]')) delete ringed.dataset.told;
    if (element !== null) element.dataset.told = '';
  }
}

function isSeen() {
  try {
    return localStorage.getItem(kSeen) !== null;
  } catch {
    return false;
  }
}
