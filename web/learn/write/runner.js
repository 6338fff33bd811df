// Runs a reader's program in run.html, apart from the page.
//
//     const runner = new Runner(element, 'write/run.html');
//     await runner.ask('run', { text, names, scene, images });
//     await runner.ask('draw', { view, fov, width, height });     // { milliseconds, picture }
//     runner.close();
//
// Throws a ProgramError if the program fails: its `kind` is 'error', 'time' (it took more than
// 2 s) or 'frame' (the whole frame is gone, as for want of memory). One question at a time.

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
    if (data.error !== undefined) throw new ProgramError('error', data.error);
    return data.answer;
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
    ['answer', 'error', 'stopped'].filter((key) => key in data).length === 1
  );
}
