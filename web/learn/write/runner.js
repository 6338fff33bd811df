// Runs a reader's program in run.html, apart from the page.
//
//     const runner = new Runner(element, 'write/run.html');
//     await runner.ask('run', { text, names, scene, images });
//     await runner.ask('draw', { view, fov, width, height });     // { milliseconds, picture }
//     runner.close();
//
// Answers have the shape and range that answers.js says. Throws a ProgramError if the program
// fails, or gives anything else: its `kind` is 'error', 'time' (it took more than
// 2 s) or 'frame' (the whole frame is gone, as for want of memory). One question at a time.

import { checkedAnswer, checkedError } from './answers.js';

const kFrameMilliseconds = 4000; // the frame ends programs after 2 s; a starting one needs more
const kStartMilliseconds = 10000;

export class ProgramError extends Error {
  constructor(kind, { name = 'Error', message = '', line = 0, column = 0, isEnd = false } = {}) {
    super(message);
    Object.assign(this, { kind, name, line, column, isEnd });
  }
}

export class Runner {
  #parent;
  #address;
  #frame = null;
  #port = null;
  #starting = null;
  #count = 0;
  #queue = Promise.resolve();

  constructor(parent, address) {
    this.#parent = parent;
    this.#address = address;
  }

  ask(action, detail) {
    const answer = this.#queue.then(() => this.#ask(action, detail));
    this.#queue = answer.catch(() => {});
    return answer;
  }

  close() {
    this.#frame?.remove();
    this.#frame = null;
    this.#port = null;
    this.#starting = null;
  }

  async #ask(action, detail) {
    if (this.#port === null) {
      if (action !== 'run') throw new ProgramError('frame');
      this.#starting ??= this.#start();
      await this.#starting;
    }
    const port = this.#port;
    const id = ++this.#count;
    const data = await new Promise((resolve) => {
      const timer = setTimeout(() => resolve(null), kFrameMilliseconds);
      port.onmessage = (event) => {
        if (!isAnswer(event.data) || event.data.id !== id) return;
        clearTimeout(timer);
        resolve(event.data);
      };
      port.postMessage({ id, action, detail });
    });
    if (data === null) {
      this.close();
      throw new ProgramError('frame');
    }
    if (data.stopped) throw new ProgramError('time');
    let error;
    try {
      if (data.error === undefined) return checkedAnswer(action, detail, data.answer);
      error = checkedError(data.error);
    } catch ({ message }) {
      error = { name: 'RangeError', message };
    }
    throw new ProgramError('error', error);
  }

  // A frame of an opaque origin, and a channel that only it and this object have.
  async #start() {
    const frame = document.createElement('iframe');
    frame.setAttribute('sandbox', 'allow-scripts');
    frame.title = 'Where your program runs';
    frame.hidden = true;
    frame.src = this.#address;
    this.#frame = frame;
    await new Promise((resolve) => {
      setTimeout(resolve, kStartMilliseconds);
      frame.addEventListener('load', resolve, { once: true });
      this.#parent.append(frame);
    });
    const { port1, port2 } = new MessageChannel();
    frame.contentWindow?.postMessage('port', '*', [port2]);
    this.#port = port1;
  }
}

function isAnswer(data) {
  return (
    typeof data === 'object' &&
    data !== null &&
    Number.isInteger(data.id) &&
    ['answer', 'error', 'stopped'].filter((key) => Object.hasOwn(data, key)).length === 1
  );
}
