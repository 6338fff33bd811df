// Two pads for thumbs, one to walk and one to look, and a button to jump. They press the keys that a keyboard would, on the canvas.
//
//     a pad's data-keys names the four keys of up, right, down, left as KeyboardEvent.code does

const kDeadZone = 0.2; // of a pad's half width: a thumb that rests in the middle presses nothing
const kDiagonal = Math.tan(Math.PI / 8); // from here on two keys are down

export class TouchPads {
  constructor(root, canvas) {
    this.canvas = canvas;
    for (const pad of root.querySelectorAll('[data-keys]')) this.#listen(pad, pad.dataset.keys.split(' '));
    // The canvas keeps the focus, and with it the game its keys.
    root.addEventListener('mousedown', (event) => event.preventDefault());
  }

  #listen(pad, codes) {
    let held = [];
    const hold = (wanted) => {
      for (const code of held) if (!wanted.includes(code)) this.#send('keyup', code);
      for (const code of wanted) if (!held.includes(code)) this.#send('keydown', code);
      held = wanted;
      pad.dataset.held = held.map((code) => codes.indexOf(code)).join(' ');
    };
    const follow = (event) => {
      const box = pad.getBoundingClientRect();
      hold(codes.length === 1 ? codes : keysTowards(codes, (2 * (event.clientX - box.left)) / box.width - 1, (2 * (event.clientY - box.top)) / box.height - 1));
    };
    pad.addEventListener('pointerdown', (event) => {
      event.preventDefault();
      pad.setPointerCapture(event.pointerId);
      follow(event);
    });
    pad.addEventListener('pointermove', (event) => {
      if (pad.hasPointerCapture(event.pointerId)) follow(event);
    });
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) pad.addEventListener(end, () => hold([]));
  }

  #send(type, code) {
    this.canvas.dispatchEvent(new KeyboardEvent(type, { code, bubbles: true, cancelable: true }));
  }
}

// The keys for a thumb at (x, y), each -1 to 1 from the pad's middle.
export function keysTowards([up, right, down, left], x, y) {
  if (Math.hypot(x, y) < kDeadZone) return [];
  const keys = [];
  if (Math.abs(y) > Math.abs(x) * kDiagonal) keys.push(y < 0 ? up : down);
  if (Math.abs(x) > Math.abs(y) * kDiagonal) keys.push(x < 0 ? left : right);
  return keys;
}
