// Lays the picture out in its box: how many pixels it has, and how large each of them is shown. A
// pixel of the picture is a whole number of the screen's own pixels wherever that leaves the box
// well filled, so edges stay even; any other scale is filtered.

export const kLargestSide = 4096; // pixels, as the engine's

const kLeastLongSide = 320; // pixels, of a picture that is made smaller to be quicker
const kLeastFill = 0.8; // of the box's width or height, below which uneven pixels are better than wide margins
const kAlmost = 1e-6;

// `size` is 'auto', 'WIDTHxHEIGHT', or a share of the box's own pixels, '50%'; the box is in pixels
// of the screen. With auto the picture has `scale` times the pixels of the box. Gives the picture's
// size and its size on the screen, in pixels each, and whether every one of its pixels covers the
// same whole number of the screen's.
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

// A picture of a size of its own: it keeps its shape.
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

// Keeps `frame`, which holds the canvas, laid out in `stage`, and says so whenever the picture's
// size changes. stop() ends that.
export class Stage {
  #box = null; // as observed: a stage in the flow of a page may end between two pixels
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
    this.scale = 1; // of the picture's sides to the box's, with the size auto
    this.#observer.observe(stage);
    // Moving to another screen changes how large its pixels are, and nothing else.
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
    // In the middle, but never between two pixels of the screen.
    this.frame.style.left = `${Math.floor((boxWidth - wanted.shownWidth) / 2) / ratio}px`;
    this.frame.style.top = `${Math.floor((boxHeight - wanted.shownHeight) / 2) / ratio}px`;
    this.frame.classList.toggle('filtered', !wanted.isEven);
    if (wanted.width === this.width && wanted.height === this.height) return;
    this.width = wanted.width;
    this.height = wanted.height;
    this.onPictureSize(wanted.width, wanted.height);
  }
}
