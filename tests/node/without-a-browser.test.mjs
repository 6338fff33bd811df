// Under jsdom and happy-dom, in which people test their pages: the tag exists and does nothing.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Worker, isMainThread, parentPort, workerData } from 'node:worker_threads';

const kMakers = {
  async jsdom() {
    const { JSDOM, VirtualConsole } = await import('jsdom');
    const virtualConsole = new VirtualConsole();
    virtualConsole.on('jsdomError', ({ message }) => complaints.push(message));
    return new JSDOM('<!doctype html>', { url: 'http://localhost/', virtualConsole }).window;
  },
  async 'happy-dom'() {
    const { Window } = await import('happy-dom');
    return new Window({ url: 'http://localhost/' });
  },
};
const complaints = [];

// Test runners put the window's names into the global scope; a worker has one of its own.
async function useElement(maker) {
  const window = await kMakers[maker]();
  const names = ['Event', 'CustomEvent', 'MutationObserver', 'location'];
  for (const name of Object.getOwnPropertyNames(window))
    if (!Reflect.has(globalThis, name) || names.includes(name))
      Object.defineProperty(globalThis, name, { configurable: true, value: window[name] });
  const { apiVersion } = await import('../../build/web/ray-caster.js');
  const { document } = window;
  document.body.innerHTML =
    '<ray-caster scene="first-steps" label="A yard" options="fov=90" autoplay>Text</ray-caster>';
  const element = document.querySelector('ray-caster');
  element.scene = 'castle';
  element.setAttribute('view', '1,1,1,1');
  for (const method of ['play', 'pause', 'enter', 'reload', 'focus']) element[method]();
  element.mouse = { speed: 2 };
  element.muted = true;
  const early = await element.whenReady().catch(({ code, message }) => ({ code, message }));
  element.remove();
  document.body.append(element);
  await new Promise((resolve) => setTimeout(resolve, 50));
  const { label, scene, state, error, warnings, currentView, paused } = element;
  return {
    apiVersion,
    early,
    complaints,
    now: { label, scene, state, error, warnings, currentView, paused },
  };
}

if (!isMainThread) {
  const complain = (reason) => complaints.push(String(reason?.stack ?? reason));
  process.on('unhandledRejection', complain);
  console.warn = complain;
  console.error = complain;
  parentPort.postMessage(await useElement(workerData));
  process.exit();
}

for (const maker of Object.keys(kMakers))
  test(`${maker}: creating the tag works and does nothing`, async () => {
    const worker = new Worker(new URL(import.meta.url), { workerData: maker });
    const found = await new Promise((resolve, reject) => {
      worker.once('message', resolve);
      worker.once('error', reject);
    });
    assert.equal(found.apiVersion, 1);
    assert.deepEqual(found.complaints, []);
    assert.deepEqual(found.now, {
      label: 'A yard',
      scene: 'castle',
      state: 'idle',
      error: null,
      warnings: [],
      currentView: null,
      paused: true,
    });
    assert.equal(found.early.code, 'engine');
    assert.match(found.early.message, /slicecast\/node draws/);
  });
