// A canvas as the engine's screen, keyboard and mouse. Listeners use the capture phase, so they run
// before the page's own; the engine decides which keys it takes from the page.
//
//     const screen = openCanvas(canvas, exports, {writeCode, takesKey});
//     screen.show(buffer, at, width, height);         // pixels at that address of the memory
//     screen.close();
//
// `exports` are those of src/app/page_shell.cpp. takesKey(code) says whether the engine gets a key;
// writeCode(code) tells it the code before slicecastKey.

// For some time after a pointer lock ends, browsers refuse a new one: such a refusal is no reason
// to steer by the cursor.
const kLockRestMilliseconds = 2000;

export function openCanvas(canvas, exports, { writeCode, takesKey }) {
  const page = canvas.ownerDocument; // may differ from the script's document
  const context = canvas.getContext('2d', { alpha: false });
  const listeners = new AbortController();
  const until = { signal: listeners.signal };
  const on = (target, type, listener) =>
    target.addEventListener(type, listener, { ...until, capture: true });
  let image = null; // a view of the engine's memory; invalid once that memory grows

  const key = (event, isDown) => {
    if (!takesKey(event.code)) return;
    writeCode(event.code);
    const flags =
      (event.ctrlKey ? 1 : 0) |
      (event.altKey ? 2 : 0) |
      (event.metaKey ? 4 : 0) |
      (event.repeat ? 8 : 0);
    if (exports.slicecastKey(isDown, flags)) event.preventDefault();
  };
  on(canvas, 'keydown', (event) => key(event, 1));
  on(canvas, 'keyup', (event) => key(event, 0));
  on(canvas, 'blur', () => exports.slicecastBlurred());
  on(page, 'visibilitychange', () => exports.slicecastHidden(page.hidden ? 1 : 0));

  // Reports the motion, and the cursor's place (-1 to 1 from edge to edge) if the engine wants it.
  on(canvas, 'mousemove', ({ clientX, clientY, movementX, movementY }) => {
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
      if (canvas.requestPointerLock) canvas.requestPointerLock()?.catch(refused);
      else refused();
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
