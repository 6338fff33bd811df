// Lays the picture out in the window: how many pixels it has, and how large each of them is shown.
// A pixel of the picture is a whole number of the screen's own pixels wherever that leaves the
// window well filled, so edges stay even.

const kLargestAutomatic = 1280 * 720; // pixels, when the picture follows the window
const kLeastFill = 0.8; // of the window's width or height, below which uneven pixels are better than wide margins

// `size` is 'auto' or 'WIDTHxHEIGHT'; the window is in pixels of the screen. Gives the picture's
// size and its size on the screen, in pixels each.
export function layOut(size, windowWidth, windowHeight) {
  const width = Math.max(1, Math.round(windowWidth));
  const height = Math.max(1, Math.round(windowHeight));
  if (size === 'auto') {
    let scale = 1;
    while (Math.ceil(width / scale) * Math.ceil(height / scale) > kLargestAutomatic) ++scale;
    const picture = { width: Math.ceil(width / scale), height: Math.ceil(height / scale) };
    return { ...picture, shownWidth: picture.width * scale, shownHeight: picture.height * scale };
  }
  const picture = { width: Number(size.split('x')[0]), height: Number(size.split('x')[1]) };
  const fits = Math.min(width / picture.width, height / picture.height);
  const whole = Math.floor(fits);
  const scale = whole >= 1 && whole >= fits * kLeastFill ? whole : fits;
  return {
    ...picture,
    shownWidth: Math.round(picture.width * scale),
    shownHeight: Math.round(picture.height * scale),
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

  layOut() {
    const ratio = window.devicePixelRatio || 1;
    const windowWidth = (this.#box?.width ?? this.stage.clientWidth) * ratio;
    const windowHeight = (this.#box?.height ?? this.stage.clientHeight) * ratio;
    const wanted = layOut(this.size, windowWidth, windowHeight);
    this.frame.style.width = `${wanted.shownWidth / ratio}px`;
    this.frame.style.height = `${wanted.shownHeight / ratio}px`;
    // In the middle, but never between two pixels of the screen.
    this.frame.style.left = `${Math.floor((windowWidth - wanted.shownWidth) / 2) / ratio}px`;
    this.frame.style.top = `${Math.floor((windowHeight - wanted.shownHeight) / 2) / ratio}px`;
    if (wanted.width === this.width && wanted.height === this.height) return;
    this.width = wanted.width;
    this.height = wanted.height;
    this.onPictureSize(wanted.width, wanted.height);
  }
}
