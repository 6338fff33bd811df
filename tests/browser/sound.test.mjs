// Sound: only after a gesture, only where it is wanted, only from the element that somebody steers;
// and what it sounds like, measured.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { launch, openPage, openScene, play } from './browser.mjs';
import { openElements, ready } from './element.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const kScript = 'ray-caster-sound.js';

// Goes into the page before its scripts. window.audio has all contexts that the page makes;
// window.loudness() is what the last of them plays at the moment. What a test evaluates counts as a
// gesture in Chromium, so gestures are counted here.
function listen() {
  const activation = { hasBeenActive: false };
  Object.defineProperty(navigator, 'userActivation', { get: () => activation });
  for (const type of ['pointerdown', 'keydown'])
    window.addEventListener(type, () => (activation.hasBeenActive = true), { capture: true });
  const all = [];
  window.audio = all;
  window.AudioContext = class extends AudioContext {
    #analyser = null;
    constructor(options) {
      super(options);
      all.push(this);
    }
    get destination() {
      if (this.#analyser === null) {
        this.#analyser = super.createAnalyser();
        this.#analyser.fftSize = 32768;
        this.#analyser.connect(super.destination);
      }
      return this.#analyser;
    }
  };
  window.loudness = () => {
    const context = all.at(-1);
    if (context === undefined) return 0;
    const samples = new Float32Array(32768);
    context.destination.getFloatTimeDomainData(samples);
    return Math.sqrt(samples.reduce((sum, sample) => sum + sample * sample, 0) / samples.length);
  };
}

const withEars = { prepare: (page) => page.addInitScript(listen) };
const states = (page) => page.evaluate(() => window.audio.map(({ state }) => state));
const untilState = (page, state) =>
  page.waitForFunction((wanted) => window.audio.at(-1)?.state === wanted, state);
const untilHeard = (page) => page.waitForFunction(() => window.loudness() > 0.0005);
const untilSilent = (page) =>
  page.waitForFunction(() => window.audio.at(-1).state === 'suspended' || window.loudness() === 0);

const held = (page, id) =>
  page.waitForFunction((which) => document.getElementById(which).entered, id);
const enter = async (page, id) => {
  await page.locator(`#${id}`).click();
  await held(page, id);
};

// Walks to and fro, so that there are steps to hear.
async function walk(page) {
  await page.keyboard.down('KeyW');
  await untilHeard(page);
  await page.keyboard.up('KeyW');
}

test('the play page sounds after a gesture, and not in a hidden page', async (t) => {
  const { page, server } = await openScene(t, browser, withEars);
  await page.evaluate(() => window.slicecast.enter()); // a script's is no gesture
  await page.waitForFunction(() => window.slicecast.entered);
  await page.waitForTimeout(300);
  assert.deepEqual(await states(page), []);
  await page.keyboard.press('KeyW');
  await untilState(page, 'running');
  await walk(page);
  const hide = (isHidden) =>
    page.evaluate((hidden) => {
      Object.defineProperty(document, 'hidden', { configurable: true, get: () => hidden });
      document.dispatchEvent(new Event('visibilitychange', { bubbles: true }));
    }, isHidden);
  await hide(true);
  await untilState(page, 'suspended');
  await hide(false);
  await untilState(page, 'running');
  await walk(page);
  await page.keyboard.press('KeyP');
  await untilState(page, 'suspended');
  await play(page);
  await untilState(page, 'running');
  await page.keyboard.press('Escape');
  await untilState(page, 'suspended');
  assert.equal((await states(page)).length, 1, 'one context for all of it');
  assert.equal(server.asked.filter((name) => name.endsWith(kScript)).length, 1);
});

test('the key and the setting switch it off, and the page remembers', async (t) => {
  const { page, context, server } = await openScene(t, browser, withEars);
  await play(page);
  await untilState(page, 'running');
  await walk(page);
  await page.keyboard.press('Semicolon');
  await page.waitForFunction(() => window.slicecast.muted);
  await untilState(page, 'suspended');
  assert.equal(await page.textContent('#toast'), 'Sound off');
  assert.equal(await page.isChecked('#set-sound'), false);

  const again = await context.newPage();
  await again.addInitScript(listen);
  await again.goto(server.address);
  await again.waitForFunction(() => document.body.dataset.state === 'paused');
  assert.equal(await again.isChecked('#set-sound'), false);
  await play(again);
  await again.waitForTimeout(300);
  assert.deepEqual(await states(again), []);
  await again.keyboard.press('Semicolon');
  await untilState(again, 'running');
  assert.equal(await again.isChecked('#set-sound'), true);
});

test('an element without the attribute never sounds', async (t) => {
  const { page, server } = await openElements(
    t,
    browser,
    '<ray-caster id="a" scene="room" controls></ray-caster>',
    withEars,
  );
  await ready(page, 'a');
  await enter(page, 'a');
  await page.keyboard.press('Semicolon');
  await page.keyboard.press('KeyW', { delay: 500 });
  assert.deepEqual(await states(page), []);
  assert.ok(!server.asked.some((name) => name.endsWith(kScript)), 'nor is its script fetched');
  assert.equal(await page.locator('#a').getByRole('button', { name: /Sound/ }).count(), 0);
  await page.keyboard.press('KeyH');
  await page.locator('#a').getByRole('dialog').waitFor();
  assert.doesNotMatch(await page.locator('#a').getByRole('dialog').textContent(), /sound/);
});

test('of several elements only the one that is steered sounds', async (t) => {
  const { page } = await openElements(
    t,
    browser,
    ['a', 'b']
      .map((id) => `<ray-caster id="${id}" scene="room" sound controls autoplay></ray-caster>`)
      .join(''),
    withEars,
  );
  await ready(page, 'a');
  await ready(page, 'b');
  await page.waitForTimeout(300);
  assert.deepEqual(await states(page), [], 'playing by itself is silent');
  // Whose world is listened to, by what its engine is asked.
  await enter(page, 'a');
  await untilState(page, 'running');
  await walk(page);
  await enter(page, 'b');
  assert.equal(await page.evaluate(() => document.getElementById('a').entered), false);
  await page.waitForTimeout(600);
  assert.deepEqual(await states(page), ['running'], 'one context, which b has now');
  await walk(page);
  await page.locator('#b').getByRole('button', { name: 'Sound off' }).click();
  await untilState(page, 'suspended');
  assert.deepEqual(
    await page.evaluate(() => ['a', 'b'].map((id) => document.getElementById(id).muted)),
    [false, true],
  );
  await page.locator('#b').getByRole('button', { name: 'Sound on' }).click();
  await untilState(page, 'running');
  await page.evaluate(() => document.getElementById('b').removeAttribute('sound'));
  await untilState(page, 'suspended');
});

test('out of sight it falls silent', async (t) => {
  const { page } = await openElements(
    t,
    browser,
    '<ray-caster id="a" scene="room" sound></ray-caster><p style="height: 4000px">Below</p>',
    withEars,
  );
  await ready(page, 'a');
  await enter(page, 'a');
  await walk(page);
  await page.keyboard.down('KeyW');
  await page.evaluate(() => window.scrollTo(0, 3000));
  await untilSilent(page);
  await page.keyboard.up('KeyW');
});

// ---- What it sounds like

const source = (name) => readFileSync(new URL(`../../web/sound/${name}`, import.meta.url), 'utf8');

// Renders sounds into samples: {left, right, rms, peak, jump, centroid}. `script` has what is heard
// from a time on, [[seconds, heard], ...].
function inStudio() {
  const kRate = 44100;
  const kSpectrum = 8192;
  const rmsOf = (samples) =>
    Math.sqrt(samples.reduce((sum, sample) => sum + sample * sample, 0) / samples.length);
  const peakOf = (samples) => samples.reduce((most, sample) => Math.max(most, Math.abs(sample)), 0);

  // The middle of the spectrum's power, in hertz, from where the sound begins.
  function centroidOf(whole) {
    const begin = whole.findIndex((sample) => Math.abs(sample) > 1e-4);
    const samples = whole.subarray(Math.min(begin, whole.length - kSpectrum));
    let weighted = 0;
    let powers = 0;
    for (let hertz = 60; hertz < 12000; hertz *= 1.1) {
      const turn = 2 * Math.cos((2 * Math.PI * hertz) / kRate);
      let [before, now] = [0, 0];
      for (let i = 0; i < kSpectrum; ++i) [before, now] = [now, turn * now - before + samples[i]];
      const power = (before * before + now * now - turn * before * now) * hertz;
      weighted += power * Math.log(hertz);
      powers += power;
    }
    return Math.exp(weighted / powers);
  }

  async function render(seconds, script) {
    const { Voices } = await import('./sound/voices.js');
    const context = new OfflineAudioContext(2, seconds * kRate, kRate);
    const voices = new Voices(context);
    for (const [time, heard] of script) {
      if (time === 0) voices.hear(heard);
      else
        context.suspend(time).then(() => {
          voices.hear(heard);
          context.resume();
        });
    }
    const buffer = await context.startRendering();
    return [buffer.getChannelData(0), buffer.getChannelData(1)];
  }

  window.studio = {
    async measure(seconds, script) {
      const [left, right] = await render(seconds, script);
      return {
        left: rmsOf(left),
        right: rmsOf(right),
        peak: Math.max(peakOf(left), peakOf(right)),
        centroid: centroidOf(left),
      };
    },
    // The greatest steps from sample to sample, for each tenth of a second.
    async jumps(seconds, script) {
      const [left] = await render(seconds, script);
      const jumps = [];
      for (let from = 1; from < left.length; from += kRate / 10) {
        let most = 0;
        for (let i = from; i < Math.min(left.length, from + kRate / 10); ++i)
          most = Math.max(most, Math.abs(left[i] - left[i - 1]));
        jumps.push(most);
      }
      return jumps;
    },
  };
}

async function openStudio(t) {
  const { page } = await openPage(t, browser, {
    query: 'studio.html',
    server: {
      files: {
        'studio.html': '<!doctype html><title>Studio</title><link rel="icon" href="favicon.svg">',
        'sound/voices.js': source('voices.js'),
        'sound/recipes.js': source('recipes.js'),
      },
    },
  });
  await page.evaluate(inStudio);
  const measure = (seconds, script) =>
    page.evaluate(([length, all]) => window.studio.measure(length, all), [seconds, script]);
  const jumps = (seconds, script) =>
    page.evaluate(([length, all]) => window.studio.jumps(length, all), [seconds, script]);
  return { measure, jumps };
}

const one = (kind, material, gain = 0.55, pan = 0) => ({ kind, material, gain, pan });

test('materials differ in their sound, and are equally loud', async (t) => {
  const { measure } = await openStudio(t);
  const steps = {};
  for (const material of [
    'stone',
    'wood',
    'earth',
    'grass',
    'sand',
    'metal',
    'glass',
    'cloth',
    'water',
  ])
    steps[material] = await measure(1, [[0, [one('step', material)]]]);
  for (const [material, { left, peak }] of Object.entries(steps)) {
    assert.ok(peak > 0.08 && peak < 0.3, `${material}: peak ${peak}`);
    assert.ok(left > 0.003 && left < 0.012, `${material}: rms ${left}`);
  }
  const { stone, wood, grass, cloth } = steps;
  assert.ok(
    stone.centroid > 2 * wood.centroid,
    `stone ${stone.centroid}, wood ${wood.centroid} Hz`,
  );
  assert.ok(grass.centroid > 1.5 * stone.centroid, `grass ${grass.centroid} Hz`);
  assert.ok(cloth.centroid < 400, `cloth ${cloth.centroid} Hz`);
});

test('sides and gains are heard', async (t) => {
  const { measure } = await openStudio(t);
  const gate = (gain, pan) => measure(2, [[0, [one('gate', 'wood', gain, pan)]]]);
  const left = await gate(1, -0.9);
  const right = await gate(1, 0.9);
  assert.ok(left.left > 3 * left.right, `left: ${left.left} and ${left.right}`);
  assert.ok(right.right > 3 * right.left, `right: ${right.left} and ${right.right}`);
  const far = await gate(0.25, 0.9);
  assert.ok(Math.abs(right.right / far.right - 4) < 0.5, `${right.right} and ${far.right}`);
  const steps = await measure(1, [[0, [one('knock', 'stone', 0.8, 0.9)]]]);
  assert.ok(steps.right > 2 * steps.left, `${steps.left} and ${steps.right}`);
});

test('nothing clips, however much sounds at once', async (t) => {
  const { measure } = await openStudio(t);
  const busy = [
    ...['stone', 'metal', 'wood'].flatMap((material) => [
      one('gate', material, 1),
      one('mover', material, 1),
    ]),
    one('water', 'water', 1),
    one('wind', 'stone', 1),
  ];
  const usual = await measure(4, [[0, [...busy, one('land', 'stone', 1)]]]);
  assert.ok(usual.peak < 0.9, `peak ${usual.peak}`);
  const crowd = Array.from({ length: 32 }, () => one('knock', 'metal', 1));
  const worst = await measure(2, [[0, [...busy, ...crowd]]]);
  assert.ok(worst.peak > 0.5 && worst.peak < 0.9, `peak ${worst.peak}`);
});

// A click is a step from one sample to the next that is far greater than those around it: where
// the noise begins again after 4 seconds, and where sounds begin and end.
test('what lasts begins, goes on and ends without clicks', async (t) => {
  const { jumps } = await openStudio(t);
  for (const [kind, material] of [
    ['water', 'water'],
    ['wind', 'stone'],
    ['gate', 'wood'],
    ['mover', 'metal'],
  ]) {
    const heard = [one(kind, material, 1)];
    const all = await jumps(10, [
      [0, heard],
      [8.5, []],
    ]);
    const middle = all.slice(10, 80).sort((a, b) => a - b);
    const usual = middle[Math.floor(middle.length / 2)];
    assert.ok(usual > 0, kind);
    assert.ok(Math.max(...all) < 2.2 * usual, `${kind}: ${Math.max(...all)} beside ${usual}`);
    assert.equal(all.at(-1), 0, `${kind} has ended`);
  }
});

test('under water everything is muffled', async (t) => {
  const { measure } = await openStudio(t);
  const under = one('submerged', 'stone', 1);
  const tread = one('step', 'glass', 1);
  const above = await measure(1, [[0.5, [tread]]]);
  const below = await measure(1, [
    [0, [under]],
    [0.5, [under, tread]],
  ]);
  assert.ok(below.centroid < 0.7 * above.centroid, `${above.centroid}, ${below.centroid} Hz`);
});
