// The bar below the picture while something is recorded or replayed. While it is shown, the picture
// ends above it, so it covers nothing.
//
//     const bar = new ReplayBar(element, caster, { address, say, fail });
//     bar.toggleRecording();      F9: records from the scene's start, or stops and saves
//     bar.record({ touch: true });      bar.stop();
//
// `element.dataset.state` is one of kParts. A recording that was just made can be watched and
// saved. One that is replayed can be paused, and moved along the bar; moving the player takes over,
// and the bar leads back.

import { playDropped } from './dropped-scene.js';
import { beginRecording, recordingFile, saveRecording, stepsOf } from './recording.js';

const kStepsPerSecond = 120;
const kInterval = 200; // milliseconds between two looks at the time of a recording
// What the arrow keys move by, in steps
const kKeys = {
  ArrowLeft: -kStepsPerSecond,
  ArrowDown: -kStepsPerSecond,
  ArrowRight: kStepsPerSecond,
  ArrowUp: kStepsPerSecond,
  PageDown: -10 * kStepsPerSecond,
  PageUp: 10 * kStepsPerSecond,
};
// The parts that each state shows
const kParts = {
  off: [],
  recording: ['stop', 'time'],
  recorded: ['watch', 'save', 'time', 'close'],
  replay: ['play', 'seek', 'time', 'close'],
  left: ['play', 'seek', 'time', 'close'], // somebody has taken over, or the end is reached
};

export class ReplayBar {
  #bar;
  #caster;
  #actions;
  #state = 'off';
  #steps = 0; // of the recording
  #at = 0; // steps of it that are done
  #file = null; // of a recording that was just made
  #isOwn = false; // that recording is replayed
  #timer = 0;
  #begins = 0; // the step at which recording began
  #held = null; // while the slider is dragged: whether the replay ran

  constructor(bar, caster, actions) {
    this.#bar = bar;
    this.#caster = caster;
    this.#actions = actions;
    const act = (name, what) => this.#part(name).addEventListener('click', what);
    act('stop', () => this.stop());
    act('watch', () => this.#watch());
    act('save', () => this.#save());
    act('play', () => this.#playOrPause());
    act('close', () => this.#close());
    this.#listenToSlider(this.#part('seek'));
    caster.addEventListener('modechange', ({ detail }) => this.#mode(detail));
    caster.addEventListener('ready', () => this.#ready());
    caster.addEventListener('framechange', () => this.#follow());
    for (const type of ['statechange', 'enterchange'])
      caster.addEventListener(type, () => this.#show());
  }

  // ---- Recording

  toggleRecording() {
    if (this.#state !== 'recording') return this.record();
    this.stop();
    this.#save();
  }

  async record({ touch = false } = {}) {
    const { address, fail } = this.#actions;
    await beginRecording(this.#caster, address, touch).catch(fail);
  }

  stop() {
    const hadFocus = this.#bar.contains(document.activeElement);
    const text = this.#caster.takeRecording();
    this.#caster.pause();
    this.#file = recordingFile(this.#caster, this.#actions.address, text);
    this.#steps = stepsOf(text);
    this.#become('recorded');
    if (hadFocus) this.#part('watch').focus();
  }

  #save() {
    saveRecording(this.#file);
    this.#actions.say(`Saved: ${this.#file.name}`);
  }

  async #watch() {
    const { address, fail } = this.#actions;
    this.#isOwn = true;
    try {
      await playDropped(this.#caster, address, [{ path: this.#file.name, file: this.#file }]);
      await this.#caster.whenReady();
      this.#caster.play();
      this.#part('play').focus();
    } catch (error) {
      fail(error);
    }
  }

  // ---- Replaying

  #playOrPause() {
    const isPlaying = this.#caster.state === 'playing' && this.#state === 'replay';
    if (isPlaying) return this.#caster.pause();
    if (this.#state === 'left') this.#caster.seek(this.#at < this.#steps ? this.#at : 0);
    this.#caster.play();
  }

  // Leaves the replay; the player stays here.
  #close() {
    this.#caster.pause();
    if (this.#state === 'replay') this.#caster.step();
    this.#become('off');
    this.#caster.focus({ preventScroll: true });
  }

  #listenToSlider(slider) {
    const release = () => {
      if (this.#held) this.#caster.play();
      this.#held = null;
    };
    slider.addEventListener('pointerdown', () => {
      this.#held = this.#state === 'replay' && this.#caster.state === 'playing';
      if (this.#held) this.#caster.pause();
    });
    for (const type of ['pointerup', 'pointercancel']) slider.addEventListener(type, release);
    slider.addEventListener('input', () => this.#seek(Number(slider.value)));
    slider.addEventListener('keydown', (event) => {
      const by = kKeys[event.key];
      if (by === undefined) return;
      event.preventDefault();
      this.#seek(this.#at + (event.shiftKey ? Math.sign(by) : by));
    });
  }

  #seek(step) {
    this.#at = Math.max(0, Math.min(this.#steps, step));
    this.#caster.seek(this.#at);
    this.#show();
  }

  // ---- What the element tells

  #mode({ mode, on }) {
    if (mode === 'recording' && on) {
      this.#begins = this.#caster.player.steps;
      this.#become('recording');
    } else if (mode === 'recording' && this.#state === 'recording') {
      this.#become('off'); // another scene was opened
    } else if (mode === 'replay' && on && this.#caster.world !== null) {
      this.#become('replay');
    } else if (mode === 'replay' && !on && this.#state === 'replay') {
      this.#at = Math.min(this.#caster.player?.steps ?? 0, this.#steps);
      this.#become('left');
      // Not within the engine's own frame
      if (this.#at === this.#steps) queueMicrotask(() => this.#caster.pause());
    }
  }

  // Another scene, with or without a recording.
  #ready() {
    const { replay } = this.#caster;
    if (!this.#isOwn) this.#file = null;
    this.#isOwn = false;
    if (replay === null) {
      if (this.#state !== 'recording') this.#become('off');
      return;
    }
    this.#steps = replay.steps;
    this.#at = replay.stepsDone;
    this.#become('replay');
  }

  #follow() {
    if (this.#state !== 'replay') return;
    const { replay } = this.#caster;
    if (replay === null || replay.isSeeking || this.#held !== null) return;
    this.#at = replay.stepsDone;
    this.#show();
  }

  // ---- What is shown

  #become(state) {
    clearInterval(this.#timer);
    if (state === 'recording') this.#timer = setInterval(() => this.#show(), kInterval);
    this.#state = state;
    this.#show();
  }

  #show() {
    const { state, entered } = this.#caster;
    const shown = this.#state === 'left' && entered ? 'off' : this.#state;
    const parts = kParts[shown];
    this.#bar.hidden = shown === 'off';
    this.#bar.dataset.state = shown;
    for (const part of this.#bar.querySelectorAll('[data-replay]'))
      part.hidden = !parts.includes(part.dataset.replay);
    if (shown === 'replay' || shown === 'left') this.#part('save').hidden = this.#file === null;
    const isPlaying = state === 'playing';
    const { classList } = document.body;
    classList.toggle('has-foot', shown !== 'off');
    classList.toggle('watching', shown === 'replay' && (isPlaying || this.#at > 0));

    const isOver = this.#state === 'left' && this.#at === this.#steps;
    const play = this.#part('play');
    play.dataset.icon = shown === 'replay' && isPlaying ? 'pause' : 'play';
    play.querySelector('span').textContent =
      play.dataset.icon === 'pause'
        ? 'Pause'
        : isOver
          ? 'Play again'
          : shown === 'left'
            ? 'Back to the recording'
            : 'Play';
    const slider = this.#part('seek');
    slider.max = String(this.#steps);
    slider.value = String(this.#at);
    slider.setAttribute('aria-valuetext', `${clock(this.#at)} of ${clock(this.#steps)}`);
    this.#part('time').textContent = this.#timeText(shown);
  }

  #timeText(shown) {
    switch (shown) {
      case 'recording':
        return `Recording ${clock((this.#caster.player?.steps ?? 0) - this.#begins)}`;
      case 'recorded':
        return `Recorded ${clock(this.#steps)}`;
      case 'off':
        return '';
      default:
        return `${clock(this.#at)} / ${clock(this.#steps)}`;
    }
  }

  #part(name) {
    return this.#bar.querySelector(`[data-replay="${name}"]`);
  }
}

// Steps as minutes and seconds: "0:12".
function clock(steps) {
  const seconds = Math.floor(Math.max(0, steps) / kStepsPerSecond);
  return `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, '0')}`;
}
