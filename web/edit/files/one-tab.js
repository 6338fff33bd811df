// Sees that one tab alone changes a world. Takes its name and a function that keeps what is not
// kept yet; asks the visitor by a dialog, and gives the world from tab to tab.
//
//     const tab = new OneTab('castle', dialog, { async flush() {}, reload() {}, copy() {} });
//     tab.hasWorld                  // else nothing may be kept here
//
// The tab that had a world first has it. Another one asks: take over, or open a copy? The tab that
// has given a world away asks the same.

const kPatience = 1500; // milliseconds: the other tab may hang

export class OneTab {
  #name;
  #dialog;
  #actions;
  #channel = new BroadcastChannel('slicecast edit');
  #id = crypto.randomUUID();
  #has = true;
  #isGiving = false; // what is not kept yet may still be
  #given = () => {};

  constructor(name, dialog, actions) {
    this.#name = name;
    this.#dialog = dialog;
    this.#actions = actions;
    this.#channel.addEventListener('message', ({ data }) => this.#hear(data));
    dialog.addEventListener('cancel', (event) => event.preventDefault());
    dialog.querySelector('[data-take]').addEventListener('click', () => this.#take());
    dialog.querySelector('[data-copy-world]').addEventListener('click', () => actions.copy());
    this.#say('open');
  }

  get hasWorld() {
    return this.#has || this.#isGiving;
  }

  async #hear({ name, id, what }) {
    if (name !== this.#name || id === this.#id) return;
    if (what === 'open' && this.#has) this.#say('here');
    else if (what === 'here') this.#ask('This world is open in another tab.');
    else if (what === 'given') this.#given();
    else if (what === 'take' && this.#has) {
      this.#isGiving = true;
      this.#ask('Another tab has taken this world over. What you did here is there, too.');
      await this.#actions.flush();
      this.#isGiving = false;
      this.#say('given');
    }
  }

  #ask(text) {
    this.#has = false;
    this.#dialog.querySelector('p').textContent = text;
    if (this.#dialog.open) return;
    for (const other of document.querySelectorAll('dialog[open]')) other.close();
    this.#dialog.showModal();
  }

  // What the other tab kept last is read anew.
  async #take() {
    const isGiven = new Promise((resolve) => {
      this.#given = resolve;
      setTimeout(resolve, kPatience);
    });
    this.#say('take');
    await isGiven;
    this.#actions.reload();
  }

  #say(what) {
    this.#channel.postMessage({ name: this.#name, id: this.#id, what });
  }
}
