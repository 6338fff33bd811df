// Lets one hear the world of a <ray-caster> with the attribute `sound` while somebody steers it.
// What makes the sounds (sound/board.js) loads when they are first wanted.
//
//     const hearing = new Hearing(host, show);
//     hearing.update(isHeld);          after any change of that, of the attribute or of `muted`

export class Hearing {
  #host;
  #show;
  #isHeld = false;
  #isOn = false;
  #board = null; // once loaded

  constructor(host, show) {
    this.#host = host;
    this.#show = show;
  }

  update(isHeld = this.#isHeld) {
    this.#isHeld = isHeld;
    const isOn = isHeld && this.#host.sound && !this.#show.muted;
    if (isOn === this.#isOn) return;
    this.#isOn = isOn;
    if (isOn) {
      this.#begin().catch(({ message }) => console.warn(`No sound: ${message}`));
    } else {
      this.#host.removeEventListener('framechange', this.#hear);
      this.#board?.release(this);
    }
  }

  async #begin() {
    this.#board ??= (await import('../ray-caster-sound.js')).board;
    if (!this.#isOn) return; // left meanwhile
    this.#board.take(this);
    this.#host.addEventListener('framechange', this.#hear);
  }

  #hear = () => {
    this.#board.hear(this, this.#show.engine.heard);
  };
}
