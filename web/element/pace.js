// Chooses how large a picture may be to reach the screen's frame rate: a controller that is told
// about every frame and chooses a scale. It knows nothing of a page.
//
//     const pace = new Pace();
//     pace.frame(time, busy);      // when the frame began, and how long all pictures in it took
//     pace.scale                   // of width and height, kLeastScale to 1
//
// All times in milliseconds, on one clock.
//
// - Frames are judged in windows of half a second. If frames are late, or nearly, the picture
//   shrinks: in proportion to the excess if drawing takes the time, otherwise by a little. If a
//   larger picture would have had time to spare for a whole second, it grows.
// - The scale moves along a ladder of rungs a few percent apart, so that nobody sees a jump.
// - If a larger picture had to shrink again soon, the next try comes later and later, so that the
//   size does not oscillate.
// - If fewer pixels did not help, something else keeps the page busy. Then the picture gets its
//   pixels back, and late frames are accepted for a while.

export const kLeastScale = 0.25;

const kRung = 0.94; // ratio of one scale to the next larger one
const kRungs = Math.ceil(Math.log(kLeastScale) / Math.log(kRung));
const kRungTime = 45; // milliseconds at least between two rungs

const kWindow = 500; // milliseconds
const kFirstWindow = 200; // shorter, to react quickly to a slow start
const kFewestFrames = 3; // per window
const kGap = 1000; // a longer time between frames, unless spent drawing, is a rest

const kLongestInterval = 1000 / 60; // a slower screen counts as a slow page
const kShortestInterval = 1000 / 240;
const kRemembered = 8; // windows used to estimate the screen's interval

const kLate = 1.2; // screen intervals; a longer time between frames is late
const kMostLate = 0.3; // share of a window's frames that may be late: other programs run too
const kTight = 0.92; // of the interval: drawing that takes this long is nearly late
const kFull = 0.8; // of the interval: what drawing may take after shrinking
const kSpare = 0.72; // of the interval: what drawing may take, by estimate, after growing
const kLateShrink = 0.88; // of the pixels, if drawing does not take the time
const kDrawingMatters = 0.5; // of the interval: drawing that takes longer is to blame
const kMostRungsUp = 3; // per step
const kWindowsUp = 2; // windows with time to spare before the picture grows

const kGivenUpSoon = 5000; // shrinking this soon after growing delays the next try
const kShortestWait = 4000;
const kLongestWait = 64000;
const kTrials = 3; // windows with fewer pixels before their effect is judged
const kRungsPerTrial = 2;
const kHelped = 0.93; // fewer pixels helped if the frame time fell below this share
const kPatience = 20000; // how long late frames are accepted if drawing is not to blame

const scaleOf = (rung) => Math.max(kLeastScale, kRung ** rung);
const pixelsOf = (rung) => scaleOf(rung) ** 2;

const quantile = (values, share) =>
  [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(share * values.length))];

export class Pace {
  #rung = 0;
  #target = 0;
  #rungTime = -Infinity; // of the last change
  #last = null; // when the last frame began
  #lastBusy = 0; // drawing time of the last frame
  #intervals = []; // of this window
  #busy = []; // drawing times of this window
  #skip = 0; // frames not to count, just after a change of size
  #windowLength = kFirstWindow;
  #shortest = []; // short intervals of the last windows
  #spare = 0; // consecutive windows with time to spare
  #grew = -Infinity;
  #wait = kShortestWait;
  #mayGrow = -Infinity;
  #trial = null; // {rung, interval, windows}: the state before shrinking although drawing was quick
  #patientUntil = -Infinity;
  #patience = kPatience;

  get scale() {
    return scaleOf(this.#rung);
  }

  // The set of pictures changed: forgets what was learned.
  renew() {
    this.#clear();
    this.#windowLength = kFirstWindow;
    this.#mayGrow = this.#patientUntil = -Infinity;
    this.#wait = kShortestWait;
    this.#patience = kPatience;
    this.#trial = null;
  }

  // Nothing moves; the next frame starts a new sequence.
  rest() {
    this.#clear();
    this.#last = null;
  }

  frame(time, busy) {
    const interval = this.#last === null ? Infinity : time - this.#last;
    const rested = interval > kGap && this.#lastBusy < 0.5 * interval;
    this.#last = time;
    this.#lastBusy = busy;
    if (rested) {
      this.#clear();
      return;
    }
    if (this.#rung !== this.#target) {
      this.#climb(time);
      return;
    }
    if (this.#skip > 0) {
      --this.#skip;
      return;
    }
    this.#intervals.push(interval);
    this.#busy.push(busy);
    const sum = this.#intervals.reduce((total, one) => total + one, 0);
    if (sum < this.#windowLength || this.#intervals.length < kFewestFrames) return;
    this.#windowLength = kWindow;
    this.#judge(time);
    this.#clear();
  }

  #clear() {
    this.#intervals = [];
    this.#busy = [];
  }

  #climb(time) {
    if (time - this.#rungTime < kRungTime) return;
    this.#rungTime = time;
    this.#rung += Math.sign(this.#target - this.#rung);
    this.#skip = 2;
  }

  #go(rung) {
    this.#target = Math.max(0, Math.min(kRungs, rung));
    this.#spare = 0;
  }

  #judge(time) {
    const screen = this.#screenInterval();
    const interval = quantile(this.#intervals, 1 - kMostLate);
    const busy = quantile(this.#busy, 0.5);
    if (interval > kLate * screen || busy > kTight * screen)
      this.#shrink(time, interval, busy, screen);
    else this.#grow(time, busy, screen);
  }

  // The second shortest of the last windows, so that one odd window does not matter. Per window,
  // the interval that a fifth of the frames stay below.
  #screenInterval() {
    this.#shortest.push(quantile(this.#intervals, 0.2));
    if (this.#shortest.length > kRemembered) this.#shortest.shift();
    const found = quantile(this.#shortest, 1 / kRemembered);
    return Math.max(kShortestInterval, Math.min(kLongestInterval, found));
  }

  #shrink(time, interval, busy, screen) {
    this.#spare = 0;
    if (time - this.#grew < kGivenUpSoon) {
      this.#wait = Math.min(kLongestWait, 2 * this.#wait);
      this.#mayGrow = time + this.#wait;
      this.#grew = -Infinity;
    }
    if (busy > kDrawingMatters * screen) {
      this.#trial = null;
      const pixels = pixelsOf(this.#rung) * Math.min(kLateShrink, (kFull * screen) / busy);
      let rung = this.#rung + 1;
      while (rung < kRungs && pixelsOf(rung) > pixels) ++rung;
      this.#go(rung);
    } else if (time >= this.#patientUntil) {
      this.#try(time, interval);
    }
  }

  // Fewer pixels may help although drawing is quick, because showing them takes time too.
  #try(time, interval) {
    this.#trial ??= { rung: this.#rung, interval, windows: 0 };
    const { rung, interval: before, windows } = this.#trial;
    if (windows < kTrials && this.#rung < kRungs) {
      ++this.#trial.windows;
      this.#go(this.#rung + kRungsPerTrial);
      return;
    }
    this.#trial = null;
    if (interval < kHelped * before) return; // it helped; the next window continues
    this.#patientUntil = time + this.#patience;
    this.#patience *= 2;
    this.#go(rung);
  }

  #grow(time, busy, screen) {
    this.#trial = null;
    const fits = (rung) =>
      (busy * pixelsOf(rung)) / pixelsOf(this.#rung) < kSpare * screen && rung >= 0;
    if (this.#rung === 0 || time < this.#mayGrow || !fits(this.#rung - 1)) {
      this.#spare = 0;
      return;
    }
    if (++this.#spare < kWindowsUp) return;
    let up = 1;
    while (up < kMostRungsUp && fits(this.#rung - up - 1)) ++up;
    if (time - this.#grew > 2 * kLongestWait) this.#wait = kShortestWait;
    this.#grew = time;
    this.#go(this.#rung - up);
  }
}
