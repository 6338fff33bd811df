// How large a picture may be so that pictures come as often as the screen shows them: a controller
// that hears of every frame and chooses a scale. It knows nothing of a page.
//
//     const pace = new Pace();
//     pace.frame(time, busy);      // when the frame began, and how long all pictures in it took
//     pace.scale                   // of width and height, kLeastScale to 1
//
// All times in milliseconds, on one clock.
//
// - Frames are judged in windows of half a second. Where they come later than the screen's
//   interval, or are about to, pixels go: as many as drawing took too long, or a few where drawing
//   is not what took the time. Where a larger picture would leave room to spare for a whole second,
//   it grows.
// - The scale goes from rung to rung of a ladder, each a few percent, so that nobody sees a leap.
// - A larger picture that had to be given up again at once is tried later and later: no hunting.
// - Where fewer pixels have not helped, something else keeps the page busy. Then the picture gets
//   its pixels back, and late frames are put up with for a while.

export const kLeastScale = 0.25;

const kRung = 0.94; // from one scale to the next smaller one
const kRungs = Math.ceil(Math.log(kLeastScale) / Math.log(kRung));
const kRungTime = 45; // milliseconds at least, on the way to another scale

const kWindow = 500; // milliseconds
const kFirstWindow = 200; // the first one, since a slow start is long
const kFewestFrames = 3; // in a window
const kGap = 1000; // from one frame to the next: the page has rested, if drawing did not take it

const kLongestInterval = 1000 / 60; // a screen that shows fewer pictures is taken for a slow page
const kShortestInterval = 1000 / 240;
const kRemembered = 8; // windows, from which the screen's interval is known

const kLate = 1.2; // intervals of the screen, from frame to frame
const kMostLate = 0.3; // of the frames of a window, that may be late: others use the machine, too
const kTight = 0.92; // of the interval: drawing that takes as much is about to be late
const kFull = 0.8; // of the interval, that drawing may take
const kSpare = 0.72; // the same, with a larger picture, before it is tried
const kLateShrink = 0.88; // of the pixels, where drawing is not what takes the time
const kDrawingMatters = 0.5; // of the interval
const kMostRungsUp = 3; // at a time
const kWindowsUp = 2; // with room to spare, before the picture grows

const kGivenUpSoon = 5000; // after growing
const kShortestWait = 4000;
const kLongestWait = 64000;
const kTrials = 3; // windows with fewer pixels, after which they must have helped
const kRungsPerTrial = 2;
const kHelped = 0.93; // of the time between two frames
const kPatience = 20000; // with late frames for which drawing is not to blame

const scaleOf = (rung) => Math.max(kLeastScale, kRung ** rung);
const pixelsOf = (rung) => scaleOf(rung) ** 2;

const quantile = (values, share) =>
  [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(share * values.length))];

export class Pace {
  #rung = 0;
  #target = 0;
  #rungTime = -Infinity; // of the last change
  #last = null; // when the last frame began
  #lastBusy = 0; // in it
  #intervals = []; // of this window
  #busy = []; // the same
  #skip = 0; // frames that are not counted: the picture has just changed its size
  #windowLength = kFirstWindow;
  #shortest = []; // of the last windows
  #spare = 0; // windows in a row
  #grew = -Infinity;
  #wait = kShortestWait;
  #mayGrow = -Infinity;
  #trial = null; // {rung, interval, windows}: before pixels went although drawing was quick
  #patientUntil = -Infinity;
  #patience = kPatience;

  get scale() {
    return scaleOf(this.#rung);
  }

  // Another picture, or several: what was learned of the last ones is worth less.
  renew() {
    this.#clear();
    this.#windowLength = kFirstWindow;
    this.#mayGrow = this.#patientUntil = -Infinity;
    this.#wait = kShortestWait;
    this.#patience = kPatience;
    this.#trial = null;
  }

  // Nothing moves; the next frame has none before it.
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

  // Of the last windows the second shortest, so that one odd window says nothing. In a window the
  // fifth part of the frames that came soonest.
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

  // Fewer pixels may help although drawing is quick: they have to be shown, too.
  #try(time, interval) {
    this.#trial ??= { rung: this.#rung, interval, windows: 0 };
    const { rung, interval: before, windows } = this.#trial;
    if (windows < kTrials && this.#rung < kRungs) {
      ++this.#trial.windows;
      this.#go(this.#rung + kRungsPerTrial);
      return;
    }
    this.#trial = null;
    if (interval < kHelped * before) return; // on, with the next window
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
