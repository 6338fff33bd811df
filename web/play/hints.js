// Hints for a first walk: each appears when needed, disappears once followed, and never returns.
// One that nobody follows ends by itself until the next visit. A gate within reach shows for a
// while how to open it, or what is missing.
//
//     const hints = new Hints(caster, line);       the line is an element with role="status"
//
// `now` sums up the walk so far: {seconds, moved, turned, stuck, player}. `moved` is in units,
// `turned` in degrees; `stuck` is how many seconds the player has pushed without moving.

import { isTouch } from './key-help.js';
import { codesOf, labelOf } from './key-list.js';

const kStorageKey = 'slicecast.hints';
const kInterval = 250; // milliseconds between two checks
const kShown = 10; // seconds that a hint stays
const kStuckSpeed = 0.2; // units per second
const kGate = 'gate'; // the name of the hint at a gate
const kWalkActions = ['forward', 'back', 'strafeLeft', 'strafeRight'];

const kHints = [
  {
    name: 'walk',
    keys: '{forward}{strafeLeft}{back}{strafeRight} walk',
    touch: 'Your left thumb walks',
    isNeeded: ({ seconds }) => seconds > 1.5, // stays until followed, so that it does not blink
    isFollowed: ({ moved }) => moved > 1,
  },
  {
    name: 'look',
    keys: 'Click the picture to look around with the mouse. {turnLeft}{turnRight} also turn',
    touch: 'Your right thumb looks around',
    isNeeded: ({ seconds, moved, turned }) => seconds > 5 && moved > 1 && turned < 20,
    isFollowed: ({ turned }) => turned > 45,
  },
  {
    name: 'jump',
    keys: '{jump} jumps onto obstacles',
    touch: 'The button with the arrow up jumps',
    isNeeded: ({ stuck }) => stuck > 1,
    isFollowed: ({ player }) => !player.onGround && !player.flying,
  },
  {
    name: 'fly',
    keys: '{fly} flies, {jump} rises',
    touch: 'The button with the wings flies',
    isNeeded: ({ seconds }) => seconds > 60,
    isFollowed: ({ player }) => player.flying,
  },
];

export class Hints {
  #caster;
  #line;
  #known; // names of the hints that were followed
  #over = new Set(); // names of those that have ended by themselves
  #current = ''; // the name of the shown one, and for how many seconds
  #seconds = 0;
  #held = new Set(); // keys
  #begin = 0;
  #now = null;
  #last = null;
  #shown = '';

  constructor(caster, line) {
    this.#caster = caster;
    this.#line = line;
    this.#known = readKnown();
    const early = { capture: true }; // the picture keeps the keys that it takes
    caster.addEventListener('keydown', ({ code }) => this.#held.add(code), early);
    caster.addEventListener('keyup', ({ code }) => this.#held.delete(code), early);
    caster.addEventListener('enterchange', () => this.#enterChanged());
    caster.addEventListener('ready', () => {
      this.#last = null;
    });
  }

  #enterChanged() {
    this.#held.clear();
    if (!this.#caster.entered) {
      clearInterval(this.#begin);
      this.#begin = 0;
      this.#show('');
    } else if (this.#begin === 0) {
      this.#now ??= { seconds: 0, moved: 0, turned: 0, stuck: 0, player: null };
      this.#last = null;
      this.#begin = setInterval(() => this.#look(), kInterval);
    }
  }

  #look() {
    const { player } = this.#caster;
    if (player === null || !this.#caster.entered) return;
    this.#now.seconds += kInterval / 1000;
    this.#now.player = player;
    this.#follow(player);
    this.#last = player;
    for (const { name, isFollowed } of kHints)
      if (!this.#known.has(name) && isFollowed(this.#now)) this.#learn(name);
    // A message of the game comes first: it may say the same.
    const isTold = document.querySelector('#message.shown') !== null;
    const text = gateText(player.gate, this.#caster.game?.locked ?? '');
    if (text === '') this.#over.delete(kGate);
    const gate = { name: kGate, keys: text, touch: text, isNeeded: () => text !== '' };
    const hint = [gate, ...kHints].find(
      ({ name, isNeeded }) =>
        !this.#known.has(name) && !this.#over.has(name) && isNeeded(this.#now),
    );
    this.#show(isTold || hint === undefined ? '' : textOf(hint));
    this.#count(hint?.name ?? '');
  }

  #count(name) {
    this.#seconds = name === this.#current ? this.#seconds + kInterval / 1000 : 0;
    this.#current = name;
    if (this.#seconds >= kShown) this.#over.add(name);
  }

  #follow(player) {
    const last = this.#last;
    if (last === null || last.map !== player.map) return;
    const step = Math.hypot(player.x - last.x, player.y - last.y);
    if (step < 5) this.#now.moved += step; // a larger step is a portal or a new view
    this.#now.turned += Math.abs(((player.heading - last.heading + 540) % 360) - 180);
    const pushes = codesOf(this.#caster, kWalkActions).some((code) => this.#held.has(code));
    const isStuck = pushes && player.speed < kStuckSpeed && !player.flying;
    this.#now.stuck = isStuck ? this.#now.stuck + kInterval / 1000 : 0;
  }

  #key(name) {
    const key = document.createElement('kbd');
    key.textContent = labelOf(this.#caster, name);
    return key;
  }

  #learn(name) {
    this.#known.add(name);
    try {
      localStorage.setItem(kStorageKey, JSON.stringify([...this.#known]));
    } catch {
      // Private windows store nothing; the hints appear again next time.
    }
  }

  // Every other part of the text is an action's name. An empty text fades the old one out.
  #show(text) {
    const parts = text
      .split(/\{(\w+)\}/)
      .map((part, index) => (index % 2 === 0 ? part : this.#key(part)));
    const shown = parts.map((part) => part.textContent ?? part).join('');
    if (shown === this.#shown) return;
    this.#shown = shown;
    if (text !== '') this.#line.replaceChildren(...parts);
    this.#line.classList.toggle('shown', text !== '');
  }
}

function textOf({ keys, touch }) {
  return isTouch() ? touch : keys;
}

function gateText(offer, locked) {
  if (offer === '') return locked;
  return isTouch() ? `The gate button ${offer}s it` : `{use} ${offer}s the gate`;
}

function readKnown() {
  try {
    return new Set(JSON.parse(localStorage.getItem(kStorageKey)) ?? []);
  } catch {
    return new Set();
  }
}
