// The script of run.html, the frame in which a reader's program runs, in a worker. The page around
// it talks to it by the port of its first message, in questions { id, action, detail }:
//
//     run { text, names, scene, images }     starts the program in a worker; names: functions
//     draw, check, explain, move             worker.js answers
//
// Answers: { id, answer }, { id, error: { name, message, line, column } }; or { id, stopped: true }
// if it took too long: then the worker has been ended, and the next program starts another.

/* global PRELUDE */ // the text of worker.js, set when run.html is built

const kLimitMilliseconds = 2000;
const kBefore = "'use strict';\n"; // what stands before the program in its script
const kLinesBefore = 1;

let page = null; // the port to the page around
let worker = null;
let program = null; // the port to the worker, once the program is read
let waiting = null; // the question, { id, timer }: the page asks one at a time
let text = '';

addEventListener('message', (event) => {
  if (page !== null || event.source !== parent || event.ports.length !== 1) return;
  [page] = event.ports;
  page.onmessage = ({ data: { id, action, detail } }) => {
    if (waiting !== null) end();
    const timer = setTimeout(() => {
      end();
      reply({ stopped: true });
    }, kLimitMilliseconds);
    waiting = { id, timer };
    if (action === 'run') run(id, detail);
    else if (program === null) reply({ error: { name: 'Error', message: 'No program runs.' } });
    else program.postMessage({ id, action, detail });
  };
});

function reply(message) {
  const { id, timer } = waiting;
  clearTimeout(timer);
  waiting = null;
  page.postMessage({ id, ...message });
}

function end() {
  worker?.terminate();
  worker = null;
  program = null;
}

function run(id, { names, scene, images, ...detail }) {
  end();
  ({ text } = detail);
  const functions = names
    .filter((name) => /^[\w$]+$/.test(name))
    .map((name) => `${name}: typeof ${name} === 'function' ? ${name} : undefined`);
  const after = `\n;takeProgram({ ${functions.join(', ')} });\n//# sourceURL=your-program.js`;
  const address = URL.createObjectURL(new Blob([PRELUDE], { type: 'text/javascript' }));
  const mine = new Worker(address);
  worker = mine;
  mine.onmessage = ({ ports: [port] }) => {
    mine.onmessage = null;
    URL.revokeObjectURL(address);
    port.onmessage = ({ data }) => {
      if (mine === worker && data.id === waiting?.id) answer(data);
    };
    program = port;
    const whole = `${kBefore}${text}${after}`;
    port.postMessage({ id, action: 'read', detail: { text: whole, scene, images } });
  };
  mine.onerror = (event) => {
    event.preventDefault();
    if (mine === worker && waiting !== null) fail(event);
  };
}

function answer({ answer: found, error }) {
  reply(error === undefined ? { answer: found } : { error: withPlace(error) });
}

// An error while the program is read: of its grammar, or in code outside of functions.
function fail({ message = '', lineno, colno }) {
  const [, name, rest] =
    /^(?:Uncaught )?(?:(\w*Error): )?(?:Failed to execute 'importScripts'[^:]*: )?(.*)$/s.exec(
      message,
    );
  const line = lineno - kLinesBefore;
  end();
  reply({ error: { name: name ?? 'Error', message: rest, ...placeIn(line, colno) } });
}

// Stacks: "at walk (your-program.js:12:5)" in Chromium, "walk@your-program.js:12:5" in the others.
function withPlace({ name, message, stack }) {
  for (const [, row, column] of stack.matchAll(/(?:your-program\.js|blob:\S*?):(\d+):(\d+)/g)) {
    const line = Number(row) - kLinesBefore;
    if (line >= 1) return { name, message, ...placeIn(line, Number(column)) };
  }
  return { name, message, line: 0, column: 0 };
}

// What is behind the program's last line is the end of the program, for the reader.
function placeIn(line, column) {
  const lines = text.split('\n');
  if (line < 1) return { line: 0, column: 0 };
  if (line <= lines.length) return { line, column };
  return { line: lines.length, column: lines.at(-1).length + 1, isEnd: true };
}
