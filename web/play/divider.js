// The divider between an old way of drawing and the exact one: a handle over the picture, moved by
// mouse, finger and arrow keys. The engine draws the line.
//
//     const divider = new Divider(handle, caster, (share) => ...);
//     divider.show(0.5);      the share of the picture on its left; 0 hides it

const kStep = 0.01;
const kLongStep = 0.1;

export class Divider {
  #handle;
  #caster;
  #share = 0;

  constructor(handle, caster, onMove) {
    this.#handle = handle;
    this.#caster = caster;
    const move = (share) => {
      this.show(Math.min(1 - kStep, Math.max(kStep, share)));
      onMove(this.#share);
    };
    handle.addEventListener('pointerdown', (event) => {
      event.preventDefault();
      handle.focus();
      handle.setPointerCapture(event.pointerId);
    });
    handle.addEventListener('pointermove', ({ pointerId, clientX }) => {
      if (!handle.hasPointerCapture(pointerId)) return;
      const { left, width } = this.#box();
      move((clientX - left) / width);
    });
    handle.addEventListener('keydown', (event) => {
      const step = event.shiftKey ? kLongStep : kStep;
      const to = {
        ArrowLeft: this.#share - step,
        ArrowDown: this.#share - step,
        ArrowRight: this.#share + step,
        ArrowUp: this.#share + step,
        Home: 0,
        End: 1,
      }[event.key];
      if (to === undefined) return;
      event.preventDefault();
      event.stopPropagation();
      move(to);
    });
    new ResizeObserver(() => this.show(this.#share)).observe(caster);
  }

  show(share) {
    this.#share = share;
    this.#handle.hidden = share <= 0;
    if (share <= 0) return;
    const { left, width } = this.#box();
    this.#handle.style.left = `${left + share * width}px`;
    this.#handle.setAttribute('aria-valuenow', String(Math.round(100 * share)));
    this.#handle.setAttribute('aria-valuetext', `${Math.round(100 * share)} % the old way`);
  }

  // The picture's box, which may be smaller than the element.
  #box() {
    const picture = this.#caster.shadowRoot.querySelector('[part~="picture"]') ?? this.#caster;
    return picture.getBoundingClientRect();
  }
}
