// Whose program runs and is kept, in every order of what may happen.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import fc from 'fast-check';

import { Desk } from '../../web/learn/write/desk.js';
import { Shelf } from '../../web/learn/write/storage.js';

const kChapter = 4;
const kOpenings = {
  ours: {},
  mine: { kept: 'mine', running: false },
  unfinished: { kept: 'mine', running: true },
};
const kEvents = [
  ...['link', 'press', 'ask', 'type', 'rest', 'rest broken', 'put', 'undo'],
  ...['back', 'begin', 'end', 'stop', 'leave'],
];

// A desk beside what a bystander notes: where each text came from, and what the reader did to it.
class Play {
  #storage = new Map();
  #links = new Map(); // texts of links and their changed copies -> whether Run was pressed for them
  #mine = new Set(); // texts that were the reader's when something took their place
  #undo = null;
  #put = null; // what it takes away again
  #count = 0;
  #told = [];

  constructor(opening) {
    const { kept, running } = kOpenings[opening];
    this.#told.push(opening);
    const storage = {
      getItem: (key) => this.#storage.get(key) ?? null,
      setItem: (key, value) => this.#storage.set(key, value),
    };
    if (kept !== undefined) new Shelf(storage).save(kChapter, kept, running);
    this.shelf = new Shelf(storage);
    this.desk = new Desk(this.shelf, kChapter);
    const found = this.shelf.open(kChapter);
    const isOwn = found !== null;
    this.desk.open({ text: found?.text ?? 'ours', isOwn, mayRun: !found?.unfinished });
    this.waits = found?.unfinished ?? false;
  }

  happen(event) {
    this.#told.push(event);
    const { desk } = this;
    const before = { text: desk.text, whose: desk.whose };
    const isTaken = /^(link|put)/.test(event) || (event === 'undo' && this.#undo !== null);
    if (isTaken && before.whose === 'reader') this.#mine.add(before.text);
    if (event === 'link') {
      desk.bring(`link ${++this.#count}\n`);
      this.#links.set(desk.text, false);
    } else if (event === 'press') {
      if (this.#links.has(desk.text)) this.#links.set(desk.text, true);
      desk.press();
      this.waits = false;
    } else if (event === 'ask') {
      desk.ask();
      this.waits = false;
    } else if (event === 'type') {
      const text = `${desk.text}${++this.#count}`;
      if (this.#links.has(desk.text)) this.#links.set(text, this.#links.get(desk.text));
      desk.type(text);
      if (before.whose === 'reader') this.#mine.delete(before.text); // the reader's own change
    } else if (event.startsWith('rest')) {
      desk.rest(event === 'rest');
      this.waits = false;
    } else if (event === 'put') {
      this.#undo = desk.put(`put ${++this.#count}`, 'a button');
      this.#put = desk.text;
      this.waits = false;
    } else if (event === 'undo') {
      this.#undo?.();
      this.#mine.delete(this.#put);
      if (this.#undo !== null) this.waits = false;
    } else if (event === 'back') {
      desk.back();
      this.waits = false;
    } else if (event === 'begin') this.#begin();
    else if (desk.isRunning && event !== 'leave') desk.end({ isStopped: event === 'stop' });
    else if (event === 'leave') desk.leave();
    this.#check();
  }

  #begin() {
    const wasRunning = this.desk.isRunning;
    const text = this.desk.begin();
    if (text === null) return;
    assert.ok(!wasRunning, this.#says('two run at once'));
    assert.equal(text, this.desk.text, this.#says('something else runs than what is shown'));
    assert.notEqual(this.#links.get(text), false, this.#says(`"${text}" runs without a click`));
    assert.ok(!this.waits, this.#says('what did not come to its end runs again unasked'));
  }

  #check() {
    const { text } = this.shelf.open(kChapter) ?? { text: null };
    const isOfLink = this.#links.has(text);
    assert.ok(!/^link \d+\n$/.test(text), this.#says('a link takes the place of what is kept'));
    assert.ok(
      !isOfLink || this.#links.get(text),
      this.#says('a changed link is kept, and has not run'),
    );
    const kept = [text, ...this.shelf.earlier(kChapter).map((each) => each.text)];
    if (this.#mine.size > 8) return; // only twelve are kept
    for (const mine of this.#mine)
      assert.ok(kept.includes(mine), this.#says(`the reader's "${mine}" is lost`));
  }

  #says(what) {
    return `${what}: ${this.#told.join(', ')}`;
  }
}

test('A program of a link runs only after a click and is not kept, in all short orders', () => {
  const kLength = 4;
  for (const opening of Object.keys(kOpenings)) {
    for (let order = 0; order < kEvents.length ** kLength; order++) {
      const play = new Play(opening);
      for (let left = order, at = 0; at < kLength; at++) {
        play.happen(kEvents[left % kEvents.length]);
        left = Math.floor(left / kEvents.length);
      }
    }
  }
});

test('The same in long orders', () => {
  fc.assert(
    fc.property(
      fc.constantFrom(...Object.keys(kOpenings)),
      fc.array(fc.constantFrom(...kEvents), { minLength: 6, maxLength: 40 }),
      (opening, events) => {
        const play = new Play(opening);
        for (const event of events) play.happen(event);
      },
    ),
    { numRuns: 3000 },
  );
});

function deskOf(opening) {
  const play = new Play(opening);
  return play;
}

// What begins to run, over and over, until nothing more does.
function runs(desk) {
  const texts = [];
  for (let text; (text = desk.begin()) !== null; desk.end({ isStopped: false })) texts.push(text);
  return texts;
}

test('What runs by itself: at the start, after changes, after buttons', () => {
  for (const [opening, first] of [
    ['ours', ['ours']],
    ['mine', ['mine']],
    ['unfinished', []],
  ])
    assert.deepEqual(runs(deskOf(opening).desk), first);
  const { desk } = deskOf('mine');
  assert.deepEqual(runs(desk), ['mine']);
  assert.deepEqual(runs(desk), []);
  desk.type('mine 2');
  assert.deepEqual(runs(desk), []);
  desk.rest(true);
  assert.deepEqual(runs(desk), ['mine 2']);
  desk.type('mine {');
  desk.rest(false);
  assert.deepEqual(runs(desk), []);
  const undo = desk.put('the answer', 'a button');
  assert.deepEqual(runs(desk), ['the answer']);
  undo();
  assert.deepEqual(runs(desk), ['mine {']);
});

test('While one runs, the newest text follows it, once', () => {
  const { desk } = deskOf('mine');
  assert.equal(desk.begin(), 'mine');
  desk.press();
  desk.type('mine 2');
  desk.rest(true);
  assert.equal(desk.begin(), null);
  desk.end({ isStopped: false });
  assert.deepEqual(runs(desk), ['mine 2']);
});

test('A link that comes while the engine loads or a program runs gives up what was to run', () => {
  for (const isRunning of [false, true]) {
    const { desk, shelf } = deskOf('mine');
    if (isRunning) desk.begin();
    desk.press();
    desk.bring('theirs');
    if (isRunning) desk.end({ isStopped: false });
    desk.ask();
    assert.deepEqual(runs(desk), []);
    desk.press();
    assert.deepEqual(runs(desk), ['theirs']);
    assert.equal(shelf.open(kChapter).text, 'mine');
    desk.back();
    assert.deepEqual(runs(desk), ['mine']);
  }
});

test("A link's program that has run is the reader's once it is changed", () => {
  const { desk, shelf } = deskOf('mine');
  desk.bring('theirs');
  desk.type('theirs 2');
  desk.rest(true);
  assert.deepEqual(runs(desk), []);
  assert.equal(shelf.open(kChapter).text, 'mine');
  desk.press();
  assert.deepEqual(runs(desk), ['theirs 2']);
  assert.equal(shelf.open(kChapter).text, 'theirs 2');
  assert.deepEqual(
    shelf.earlier(kChapter).map(({ text, why }) => [text, why]),
    [['mine', 'Before the link']],
  );
});

test('What does not come to its end stays unfinished, whatever else is shown or left', () => {
  const { desk, shelf } = deskOf('unfinished');
  desk.leave();
  assert.equal(shelf.open(kChapter).unfinished, true);
  desk.bring('theirs');
  desk.press();
  assert.deepEqual(runs(desk), ['theirs']);
  assert.equal(shelf.open(kChapter).unfinished, true);
});
