// One line below the picture that tells for two seconds what a key has just done.
//
//     const toast = new Toast(line);      an element with role="status"
//     toast.show('Time of day: dusk');

const kShown = 2200; // milliseconds

export class Toast {
  #line;
  #timer = 0;

  constructor(line) {
    this.#line = line;
  }

  show(text) {
    clearTimeout(this.#timer);
    this.#line.textContent = text;
    this.#line.classList.add('shown');
    this.#timer = setTimeout(() => this.#line.classList.remove('shown'), kShown);
  }
}
