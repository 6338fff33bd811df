// A canvas as the engine's screen, keyboard and mouse. Listeners use the capture phase, so they run
// before the page's own. What the engine takes, keys and the motion of a held pointer, goes no
// further: a page around it has shortcuts of its own.
//
//     const screen = openCanvas(canvas, exports, {writeCode, takesKey});
//     screen.show(buffer, at, width, height);         // pixels at that address of the memory
//     screen.close();
//
// `exports` are those of src/app/page_shell.cpp. takesKey(code) says whether the engine gets a key;
// writeCode(code) tells it the code before slicecastKey.

import { Trouble } from './trouble.js';

// For some time after a pointer lock ends, browsers refuse a new one: such a refusal is no reason
// to steer by the cursor.
const kLockRestMilliseconds = 2000;

// Browsers now and then report one motion of some hundred pixels out of nowhere. A hand speeds up
// over several events; should it not, only the first one is lost.
const kWildPixels = 150;
const kWildFactor = 8; // times the motion before

export function openCanvas(canvas, exports, { writeCode, takesKey }) {
  const page = canvas.ownerDocument; // may differ from the script's document
  const context = canvas.getContext('2d', { alpha: false });
  if (context === null)
    throw new Trouble('There can be no picture', 'This browser gives the page no canvas.');
  const listeners = new AbortController();
  const until = { signal: listeners.signal };
  const on = (target, type, listener) =>
    target.addEventListener(type, listener, { ...until, capture: true });
  let image = null; // a view of the engine's memory; invalid once that memory grows

  const down = new Set(); // codes of keys that the engine took
  const key = (event, isDown) => {
    if (!takesKey(event.code)) return;
    writeCode(event.code);
    const flags =
      (event.ctrlKey ? 1 : 0) |
      (event.altKey ? 2 : 0) |
      (event.metaKey ? 4 : 0) |
      (event.repeat ? 8 : 0);
    const isTaken = exports.slicecastKey(isDown, flags);
    if (isTaken) event.preventDefault();
    if (isDown && isTaken) down.add(event.code);
    if (isDown ? isTaken : down.delete(event.code)) event.stopPropagation();
  };
  on(canvas, 'keydown', (event) => key(event, 1));
  on(canvas, 'keyup', (event) => key(event, 0));
  on(canvas, 'blur', () => exports.slicecastBlurred());
  const lookAnew = () => exports.slicecastHidden(page.hidden ? 1 : 0);
  on(page, 'visibilitychange', lookAnew);
  // After a restart of the browser's graphics process a canvas is black.
  on(canvas, 'contextrestored', lookAnew);

  // Reports the motion, and the cursor's place (-1 to 1 from edge to edge) if the engine wants it.
  let lastMotion = 0; // pixels
  on(canvas, 'mousemove', (event) => {
    const { clientX, clientY, movementX, movementY } = event;
    if (holdsPointer()) event.stopPropagation();
    const motion = Math.hypot(movementX, movementY);
    const isWild = motion > kWildPixels && motion > kWildFactor * lastMotion;
    lastMotion = motion;
    if (isWild && holdsPointer()) return;
    if (!exports.slicecastPointerMoved(movementX, movementY)) return;
    const { left, top, width, height } = canvas.getBoundingClientRect();
    if (width > 0 && height > 0)
      exports.slicecastCursorAt(
        (2 * (clientX - left)) / width - 1,
        (2 * (clientY - top)) / height - 1,
      );
  });
  on(canvas, 'mouseleave', () => exports.slicecastCursorLeft());

  // Pressing the mouse or tapping focuses the canvas without scrolling; a dragging finger scrolls
  // the page. A click asks for the pointer lock; if that is refused, the cursor's place steers.
  let hasAsked = false; // for the pointer lock, without an answer so far
  let wasHeld = false;
  let lockEnd = -Infinity;
  const holdsPointer = () => canvas.getRootNode().pointerLockElement === canvas;
  const refused = () => {
    if (
      hasAsked &&
      !listeners.signal.aborted &&
      performance.now() - lockEnd > kLockRestMilliseconds
    )
      exports.slicecast_steerByCursor(1);
    hasAsked = false;
  };
  canvas.addEventListener(
    'pointerdown',
    ({ pointerType }) => pointerType !== 'touch' && canvas.focus({ preventScroll: true }),
    until,
  );
  page.addEventListener('pointerlockerror', refused, until);
  on(page, 'pointerlockchange', () => {
    if (holdsPointer()) hasAsked = false;
    else if (wasHeld) lockEnd = performance.now();
    wasHeld = holdsPointer();
    exports.slicecastPointerHeld(wasHeld ? 1 : 0);
  });
  canvas.addEventListener(
    'click',
    ({ pointerType }) => {
      canvas.focus({ preventScroll: true });
      if ((pointerType && pointerType !== 'mouse') || holdsPointer()) return;
      hasAsked = true;
      holdPointer(canvas).catch(refused);
    },
    until,
  );

  return {
    show(buffer, at, width, height) {
      if (
        image?.data.buffer !== buffer ||
        image.data.byteOffset !== at ||
        image.width !== width ||
        image.height !== height
      ) {
        image = new ImageData(new Uint8ClampedArray(buffer, at, width * height * 4), width, height);
      }
      context.putImageData(image, 0, 0);
    },
    close() {
      if (holdsPointer()) page.exitPointerLock();
      listeners.abort();
    },
  };
}

// The mouse's own motion, which no system speeds up, where the browser offers it. Rejects if the
// pointer cannot be held.
async function holdPointer(canvas) {
  try {
    await canvas.requestPointerLock({ unadjustedMovement: true });
  } catch (error) {
    if (error.name !== 'NotSupportedError') throw error;
    await canvas.requestPointerLock();
  }
}
