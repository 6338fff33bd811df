// The page's one board of sound: an AudioContext that exists only after a gesture, and belongs to
// one element at a time.
//
//     board.take(element);              from now on it may sound
//     board.hear(element, numbers);     once a picture: engine.heard
//     board.release(element);           silence
//
// Sounds need pictures: when none comes for kStillMilliseconds, as when the world is paused or out
// of sight, everything that lasts fades out. In a hidden page, and while no element has the board,
// the context is suspended.

import { heardOf } from './heard.js';
import { Voices } from './voices.js';

const kStillMilliseconds = 300;
const kFadeMilliseconds = 250; // then the context is suspended
const kGestures = ['pointerdown', 'keydown'];

class Board {
  #owner = null;
  #context = null;
  #voices = null;
  #isFirst = true; // the next pictures' sounds have begun before anybody listened
  #stillTimer = 0;
  #endTimer = 0;

  // 'none' before the first gesture, else the state of the context.
  get state() {
    return this.#context?.state ?? 'none';
  }

  take(owner) {
    if (this.#owner === owner) return;
    if (this.#owner === null) this.#listen(true);
    else this.#voices?.hush();
    this.#owner = owner;
    this.#isFirst = true;
    this.#wake();
  }

  hear(owner, numbers) {
    if (owner !== this.#owner || this.state !== 'running') return;
    this.#voices.hear(heardOf(numbers), { isFirst: this.#isFirst });
    this.#isFirst = false;
    clearTimeout(this.#stillTimer);
    this.#stillTimer = setTimeout(() => this.#still(), kStillMilliseconds);
  }

  release(owner) {
    if (owner !== this.#owner) return;
    this.#owner = null;
    this.#listen(false);
    this.#still();
    this.#endTimer = setTimeout(() => this.#context?.suspend(), kFadeMilliseconds);
  }

  #still() {
    clearTimeout(this.#stillTimer);
    this.#voices?.hush();
    this.#isFirst = true;
  }

  // A browser may refuse sound until a gesture, and stop it for a call: each gesture tries again.
  #listen(isOn) {
    const change = isOn ? 'addEventListener' : 'removeEventListener';
    for (const type of kGestures) window[change](type, this.#wake, { capture: true });
    document[change]('visibilitychange', this.#wake);
  }

  #wake = () => {
    clearTimeout(this.#endTimer);
    if (document.hidden) {
      this.#context?.suspend();
      return;
    }
    // Where the browser does not tell about gestures, somebody steers, which takes one.
    if (navigator.userActivation?.hasBeenActive === false) return;
    if (this.#context === null) {
      this.#context = new AudioContext({ latencyHint: 'interactive' });
      this.#voices = new Voices(this.#context);
    }
    if (this.#context.state !== 'running') this.#context.resume().catch(() => {});
  };
}

export const board = new Board();
