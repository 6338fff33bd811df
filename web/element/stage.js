// Lays the picture out in its box: how many pixels it has, and how large they are shown. Each pixel
// covers a whole number of screen pixels if that fills the box well, so that edges stay even; other
// scales are filtered.

export const kLargestSide = 4096; // pixels, as in the engine

const kLeastLongSide = 320; // pixels; the automatic size goes no lower
const kLeastFill = 0.8; // of the box; below that, uneven pixels are better than wide margins
const kAlmost = 1e-6;

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

// Keeps `frame`, which holds the canvas, laid out in `stage`, and reports each change of the
// picture's size, until stop().
export class Stage {
  #box = null; // the observed size, which need not be whole pixels
  #observer = new ResizeObserver((entries) => {
    this.#box = entries.at(-1).contentRect;
    this.layOut();
  });
  #onWindow = () => this.layOut();

  constructor(stage, frame, onPictureSize) {
    this.stage = stage;
    this.frame = frame;
    this.onPictureSize = onPictureSize;
    this.size = 'auto';
    this.scale = 1; // for the size auto
    this.#observer.observe(stage);
    // Moving to another screen may change only devicePixelRatio.
    window.addEventListener('resize', this.#onWindow);
  }

  stop() {
    this.#observer.disconnect();
    window.removeEventListener('resize', this.#onWindow);
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
    const ratio = window.devicePixelRatio || 1;
    const boxWidth = (this.#box?.width ?? this.stage.clientWidth) * ratio;
    const boxHeight = (this.#box?.height ?? this.stage.clientHeight) * ratio;
    const wanted = layOut(this.size, boxWidth, boxHeight, this.scale);
    this.frame.style.width = `${wanted.shownWidth / ratio}px`;
    this.frame.style.height = `${wanted.shownHeight / ratio}px`;
    // Centred on whole screen pixels.
    this.frame.style.left = `${Math.floor((boxWidth - wanted.shownWidth) / 2) / ratio}px`;
    this.frame.style.top = `${Math.floor((boxHeight - wanted.shownHeight) / 2) / ratio}px`;
    this.frame.classList.toggle('filtered', !wanted.isEven);
    if (wanted.width === this.width && wanted.height === this.height) return;
    this.width = wanted.width;
    this.height = wanted.height;
    this.onPictureSize(wanted.width, wanted.height);
  }
}
