// The panel of the reader's program, as far as it needs no page: what is kept, codes for links,
// words for errors, and how a program goes from one chapter to the next.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { stepOf } from '../../tools/learn/write-panel.mjs';
import { makeStates } from '../../web/learn/raycaster/states.js';
import { carry } from '../../web/learn/write/carry.js';
import { newLines } from '../../web/learn/write/code.js';
import { explain, suspicions } from '../../web/learn/write/errors.js';
import { percent } from '../../web/learn/write/make.js';
import { codeIn, codeOf, textOf } from '../../web/learn/write/share.js';
import { Shelf } from '../../web/learn/write/storage.js';

const states = makeStates(readFileSync('web/learn/raycaster/raycaster.txt', 'utf8'));

class FakeStorage extends Map {
  getItem = (key) => this.get(key) ?? null;
  setItem = (key, value) => {
    if (this.isFull) throw new DOMException('full', 'QuotaExceededError');
    this.set(key, String(value));
  };
}

// ---- What is kept

test('A chapter opens its own program, or that of the chapter before', () => {
  const storage = new FakeStorage();
  const shelf = new Shelf(storage);
  assert.equal(shelf.open(4), null);
  shelf.save(3, 'three', false);
  assert.deepEqual(shelf.open(4), { text: 'three', from: 3, unfinished: false });
  shelf.save(4, 'four', false);
  assert.deepEqual(new Shelf(storage).open(4), { text: 'four', from: 4, unfinished: false });
  assert.deepEqual(new Shelf(storage).open(3), { text: 'three', from: 3, unfinished: false });
  assert.equal(shelf.open(6), null);
  assert.equal(shelf.before(6), 4);
  assert.equal(shelf.before(3), 0);
});

test('A program that never came to its end is unfinished until it does', () => {
  const storage = new FakeStorage();
  const shelf = new Shelf(storage);
  shelf.save(2, 'for (;;);', true);
  assert.equal(new Shelf(storage).open(2).unfinished, true);
  assert.equal(new Shelf(storage).open(3).unfinished, true);
  shelf.finish(2);
  assert.equal(new Shelf(storage).open(2).unfinished, false);
});

test('Two tabs do not lose work to each other', () => {
  const storage = new FakeStorage();
  const [one, two] = [new Shelf(storage), new Shelf(storage)];
  one.save(1, 'begun', false);
  one.open(1);
  two.open(1);
  one.save(1, 'one', false);
  two.save(1, 'two', true);
  assert.equal(one.open(1).text, 'two');
  assert.deepEqual(
    two.earlier(1).map(({ text, why }) => [text, why]),
    [['one', 'Another tab']],
  );
  // The end of one tab's run says nothing about the other's.
  const three = new Shelf(storage);
  three.finish(1);
  assert.equal(new Shelf(storage).open(1).unfinished, true);
});

test('Earlier versions are kept without repetition, and not for ever', () => {
  const shelf = new Shelf(new FakeStorage());
  shelf.save(1, 'mine', false);
  for (let count = 0; count < 30; count++) shelf.keep(1, `text ${count}`, 'Before the answer');
  shelf.keep(1, 'text 29', 'Before the answer');
  const texts = shelf.earlier(1).map(({ text }) => text);
  assert.equal(texts[0], 'text 29');
  assert.equal(new Set(texts).size, texts.length);
  assert.ok(texts.length > 5 && texts.length < 20);
  assert.equal(shelf.open(1).text, 'mine');
});

test('A full, missing or spoilt storage does not stop the panel', () => {
  const full = new FakeStorage();
  full.isFull = true;
  const shelf = new Shelf(full);
  shelf.save(1, 'text', true);
  assert.equal(shelf.fails, true);
  full.isFull = false;
  shelf.save(1, 'text', true);
  assert.equal(shelf.fails, false);

  const none = new Shelf(null);
  assert.equal(none.open(1), null);
  none.save(1, 'text', true);
  assert.equal(none.fails, true);

  for (const spoilt of ['{', 'null', '7', '{"text":7}', '{"text":"a","earlier":[1,{"text":2}]}']) {
    const storage = new FakeStorage([['slicecast.learn.program.1', spoilt]]);
    const opened = new Shelf(storage);
    assert.ok(opened.open(1) === null || opened.open(1).text === 'a', spoilt);
    assert.deepEqual(opened.earlier(1), []);
  }
});

// ---- Links

test('A program goes into a link and comes back', async () => {
  for (const text of ['', 'x', 'function draw() {}\n// "é", 🧱, </script>\n', states.answer(22)]) {
    const code = await codeOf(text);
    assert.match(code, /^1\.[\w-]+$/);
    assert.equal(await textOf(code), text);
  }
  const code = await codeOf(states.answer(22));
  assert.ok(code.length < 8000, `the last state takes ${code.length} letters`);
});

test('A link that is not one is refused', async () => {
  const code = await codeOf(states.answer(4));
  await assert.rejects(textOf(code.slice(0, 400)), /damaged/);
  await assert.rejects(textOf('1.AAAA'), /damaged/);
  await assert.rejects(textOf('2.AAAA'), /no program/);
  await assert.rejects(textOf(''), /no program/);
  // A few letters that would become megabytes.
  await assert.rejects(textOf(await codeOf('a'.repeat(5e6))), /damaged/);
});

test('A code is found in the address', () => {
  assert.equal(codeIn('#program=1.ab-_'), '1.ab-_');
  assert.equal(codeIn('#other=2&program=1.x'), '1.x');
  assert.equal(codeIn('#write'), null);
  assert.equal(codeIn(''), null);
});

// ---- Errors. Messages are those of Chromium, Firefox and WebKit.

const program = `function walk(map, eye) {
  const near = 1;
  const { forward, right: side } = map;
  return near;
}
function draw(picture) {
  return walk(picture);
}
`;
const thrown = (name, message, place = { line: 7, column: 3 }) => ({
  kind: 'error',
  name,
  message,
  ...place,
});

for (const [name, messages, words] of [
  [
    'a name that is nowhere',
    ['faar is not defined', "Can't find variable: faar"],
    /no `faar` here/,
  ],
  [
    'a name with a slip',
    ['pictrue is not defined', "Can't find variable: pictrue"],
    /mean `picture`/,
  ],
  ['a name of another function', ['near is not defined'], /`near`, but not here/],
  ['an undeclared variable', ['assignment to undeclared variable pictur'], /mean `picture`/],
  [
    'a value that is not there',
    [
      "Cannot read properties of undefined (reading 'forward')",
      `can't access property "forward", map is undefined`,
      "undefined is not an object (evaluating 'map.forward')",
      'map is undefined',
    ],
    /undefined.*`return` missing/s,
  ],
  [
    'a call of what is no function',
    ['walk is not a function', "walk is not a function. (In 'walk()', 'walk' is 1)"],
    /`walk` is called like a function/,
  ],
  ['no list', ['walk is not iterable', 'undefined is not iterable'], /list|`return`/],
  [
    'a constant',
    [
      'Assignment to constant variable.',
      "invalid assignment to const 'near'",
      'Attempted to assign to readonly property.',
    ],
    /`const` gets another value/,
  ],
  ['recursion', ['Maximum call stack size exceeded', 'too much recursion'], /calls itself/],
  ['a list of impossible length', ['Invalid array length'], /length/],
  [
    'a use above the declaration',
    ["Cannot access 'near' before initialization"],
    /`near` is used above/,
  ],
])
  test(`In plain words: ${name}`, () => {
    for (const message of messages) {
      const { says, raw, line } = explain(thrown('ReferenceError', message), program);
      assert.match(says, words, message);
      assert.equal(raw, `ReferenceError: ${message}`);
      assert.equal(line, 7);
    }
  });

test('In plain words: brackets', () => {
  const open =
    'function one() {\n  if (true) {\n    return 1;\n}\n\nfunction two() {\n  return 2;\n}\n';
  const end = thrown('SyntaxError', 'Unexpected end of input', { line: 8, column: 2, isEnd: true });
  const found = explain(end, open);
  assert.match(found.says, /`\{` is never closed/);
  assert.equal(found.line, 1);
  const extra = 'function one() {\n  return 1;\n}\n}\n';
  assert.deepEqual(explain(thrown('SyntaxError', "Unexpected token '}'"), extra), {
    says: 'This `}` closes nothing.',
    line: 4,
    column: 1,
    raw: "SyntaxError: Unexpected token '}'",
  });
  const mixed = 'const a = [1, 2);\n';
  assert.match(
    explain(thrown('SyntaxError', 'x'), mixed).says,
    /`\)` does not match the `\[` of line 1/,
  );
  // Brackets in texts and comments do not count.
  const fine = "const a = '{'; // (\nconst b = `[${a}`;\nconst a = 1;\n";
  const twice = thrown('SyntaxError', "Identifier 'a' has already been declared");
  assert.match(explain(twice, fine).says, /declared twice/);
});

test('In plain words: a loop without end, and no memory', () => {
  const text = 'function draw() {\n  while (true) {\n  }\n}\n';
  const { says, line } = explain({ kind: 'time' }, text);
  assert.match(says, /more than 2 seconds/);
  assert.equal(line, 2);
  assert.match(explain({ kind: 'frame' }, text).says, /memory/);
});

test('An unknown error keeps its message', () => {
  const { says, raw } = explain(thrown('TypeError', 'Something new'), program);
  assert.equal(says, 'The program stops here.');
  assert.equal(raw, 'TypeError: Something new');
});

test('A comparison with one = and a stray ; are found', () => {
  const text =
    "if (a = 1) f();\nwhile (b === 2) f();\nfor (let i = 0; i < 3; i++);\nif (c >= 1 && d !== '=') f();\n" +
    'if (a <= b) f();\nconst g = (x) => x;\nif (list.some((x) => x)) f();\n';
  assert.deepEqual(
    suspicions(text).map(({ line, says }) => [line, says.includes('===')]),
    [
      [1, true],
      [3, false],
    ],
  );
});

test('No suspicion falls on our own programs', () => {
  for (let chapter = 1; chapter <= states.chapters; chapter++)
    for (const text of [states.start(chapter), states.answer(chapter)])
      assert.deepEqual(suspicions(text), [], `chapter ${chapter}`);
});

// ---- From chapter to chapter

test("The last chapter's answer becomes the next chapter's start", () => {
  for (let chapter = 2; chapter <= states.chapters; chapter++) {
    const step = stepOf(states, chapter);
    const carried = carry(states.answer(chapter - 1), step);
    assert.equal(carried, step.start, `chapter ${chapter}`);
  }
});

test("The reader's own functions and lines come along", () => {
  const step = stepOf(states, 4);
  const own = states
    .answer(3)
    .replace('return x >= 0', 'return 0 <= x')
    .concat('\nconst kMine = 3;\n\n// Half of it.\nfunction half(a) {\n  return a / 2;\n}\n');
  const carried = carry(own, step);
  assert.match(carried, /return 0 <= x/);
  assert.match(carried, /^const kMine = 3;/m);
  assert.match(carried, /\/\/ Half of it.\nfunction half/);
  for (const name of step.names) assert.match(carried, new RegExp(`function ${name}\\b`));
});

test('New lines of an answer are found', () => {
  const before = 'function a() {\n  return 1;\n}\n';
  const after = 'function a() {\n  const b = 2;\n  return 1;\n}\nfunction c() {\n  return 1;\n}\n';
  assert.deepEqual([...newLines(before, after)], [1, 4, 5, 6]);
  assert.deepEqual([...newLines(after, after)], []);
});

test('A share below all is never written as all', () => {
  assert.equal(percent(1), '100 %');
  assert.equal(percent(0.99999), '99.99 %');
  assert.equal(percent(0.5), '50 %');
  assert.equal(percent(0), '0 %');
});
