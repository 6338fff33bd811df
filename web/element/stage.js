// Lays the picture out in its box: how many pixels it has, and how large they are shown. Each pixel
// covers a whole number of screen pixels if that fills the box well, so that edges stay even; other
// scales are filtered.

export const kLargestSide = 4096; // pixels, as in the engine

const kLeastLongSide = 320; // pixels; the automatic size goes no lower
const kLeastFill = 0.8; // of the box; below that, uneven pixels are better than wide margins
const kAlmost = 1e-6;
const kAlike = 0.01; // between the two sides' factors

// `size` is 'auto', 'WIDTHxHEIGHT', or a share of the box such as '50%'; the box is in screen
// pixels. With auto the picture's sides are `scale` times the box's. Returns the picture's size,
// its size on the screen, and whether each of its pixels covers the same whole number of screen
// pixels.
export function layOut(size, boxWidth, boxHeight, scale = 1) {
  const width = Math.max(1, Math.round(boxWidth));
  const height = Math.max(1, Math.round(boxHeight));
  if (size.includes('x')) return fit(...size.split('x').map(Number), width, height);
  const longer = Math.max(width, height);
  const wanted =
    size === 'auto'
      ? Math.max(scale, Math.min(1, kLeastLongSide / longer))
      : parseFloat(size) / 100;
  const share = Math.min(wanted, kLargestSide / longer);
  const whole = Math.round(1 / share);
  if (Math.abs(1 / share - whole) < kAlmost)
    return shown(Math.ceil(width / whole), Math.ceil(height / whole), whole);
  return {
    width: Math.max(1, Math.round(width * share)),
    height: Math.max(1, Math.round(height * share)),
    shownWidth: width,
    shownHeight: height,
    isEven: false,
  };
}

// A picture of a fixed size keeps its shape.
function fit(width, height, boxWidth, boxHeight) {
  const fits = Math.min(boxWidth / width, boxHeight / height);
  const whole = Math.floor(fits);
  return shown(width, height, whole >= 1 && whole >= fits * kLeastFill ? whole : fits);
}

function shown(width, height, scale) {
  return {
    width,
    height,
    shownWidth: Math.round(width * scale),
    shownHeight: Math.round(height * scale),
    isEven: Number.isInteger(scale),
  };
}

// How much larger than laid out a box is on the screen: an ancestor's transform, as a slide show
// has, enlarges both sides alike. Transforms that turn or shrink it are left to the browser.
function enlargement(across, down) {
  return across > 1 + kAlike && Math.abs(across - down) < kAlike ? across : 1;
}

// Keeps `frame`, which holds the canvas, laid out in `stage`, and reports each change of the
// picture's size, until stop(). layOut() finds what no browser reports: a new transform.
export class Stage {
  #box = null; // the observed size: {width, height} in CSS pixels, which need not be whole
  #pixels = null; // the same in screen pixels, where the browser tells them; counts zoom
  #ended = new AbortController();
  #observer = new ResizeObserver((entries) => {
    const { contentRect, devicePixelContentBoxSize: exact } = entries.at(-1);
    this.#box = contentRect;
    this.#pixels = exact ? { width: exact[0].inlineSize, height: exact[0].blockSize } : null;
    this.layOut();
  });

  constructor(stage, frame, onPictureSize) {
    this.stage = stage;
    this.frame = frame;
    this.onPictureSize = onPictureSize;
    this.size = 'auto';
    this.scale = 1; // for the size auto
    const isExact = 'devicePixelContentBoxSize' in ResizeObserverEntry.prototype;
    this.#observer.observe(stage, { box: isExact ? 'device-pixel-content-box' : 'content-box' });
    this.#watchDensity();
    window.addEventListener('resize', () => this.layOut(), { signal: this.#ended.signal });
  }

  stop() {
    this.#observer.disconnect();
    this.#ended.abort();
  }

  // Another screen, or another zoom of the page.
  #watchDensity() {
    const { signal } = this.#ended;
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener(
      'change',
      () => {
        this.layOut();
        this.#watchDensity();
      },
      { once: true, signal },
    );
  }

  setSize(size) {
    this.size = size;
    this.layOut();
  }

  setScale(scale) {
    this.scale = scale;
    this.layOut();
  }

  layOut() {
    const { stage, frame } = this;
    const { width, height } = this.#box ?? { width: stage.clientWidth, height: stage.clientHeight };
    const density = window.devicePixelRatio || 1;
    const pixels = this.#pixels ?? { width: width * density, height: height * density };
    const onScreen = stage.getBoundingClientRect();
    const enlarged = enlargement(
      (onScreen.width * density) / pixels.width,
      (onScreen.height * density) / pixels.height,
    );
    const boxWidth = pixels.width * enlarged;
    const boxHeight = pixels.height * enlarged;
    // Screen pixels for each of the frame's. The box's are rounded, which must not count as a zoom.
    const measured = boxWidth / width || density;
    const ratio = Math.abs(measured / density - 1) < kAlike ? density : measured;
    const wanted = layOut(this.size, boxWidth, boxHeight, this.scale);
    frame.style.width = `${wanted.shownWidth / ratio}px`;
    frame.style.height = `${wanted.shownHeight / ratio}px`;
    // Centred on whole screen pixels.
    frame.style.left = `${Math.floor((boxWidth - wanted.shownWidth) / 2) / ratio}px`;
    frame.style.top = `${Math.floor((boxHeight - wanted.shownHeight) / 2) / ratio}px`;
    frame.classList.toggle('filtered', !wanted.isEven);
    if (wanted.width === this.width && wanted.height === this.height) return;
    this.width = wanted.width;
    this.height = wanted.height;
    this.onPictureSize(wanted.width, wanted.height);
  }
}
