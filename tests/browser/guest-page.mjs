// A third-party page with <ray-caster> in it, and functions that observe it.
//
//     const { page, server } = await openGuest(t, browser,
//       { body: '<ray-caster scene="room"></ray-caster>' });
//     await ready(page);
//
// The scene "room" is the one of room.mjs.

import { openPage } from './browser.mjs';

export const kRoom = '<ray-caster scene="room" style="width: 320px"></ray-caster>';
export const kScript = '<script type="module" src="ray-caster.js"></script>';
const kWaitMilliseconds = 60_000; // only a failure takes so long, and a machine may be busy

export function guestPage(body, { head = '', script = kScript } = {}) {
  return `<!doctype html>
<html lang="en">
<head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>A page of somebody else</title>${head}${script}</head>
<body><main><h1>A lesson</h1>${body}</main></body>
</html>`;
}

export function openGuest(
  t,
  browser,
  { body = kRoom, head, script, server = {}, ...options } = {},
) {
  const files = {
    'favicon.ico': '',
    'guest.html': guestPage(body, { head, script }),
    ...server.files,
  };
  return openPage(t, browser, {
    query: 'guest.html',
    viewport: { width: 800, height: 600 },
    ...options,
    server: { ...server, files },
  });
}

// Waits until all elements of the page have loaded their scenes. Schedules nothing in the page,
// because watchPage() would count it.
export function ready(page, selector = 'ray-caster') {
  return page.evaluate(async (which) => {
    await customElements.whenDefined('ray-caster');
    await Promise.all([...document.querySelectorAll(which)].map((element) => element.whenReady()));
  }, selector);
}

// Waits for a condition in the page without scheduling anything there.
export async function until(page, condition, argument) {
  const end = Date.now() + kWaitMilliseconds;
  for (;;) {
    const found = await page.evaluate(condition, argument);
    if (found) return found;
    if (Date.now() > end) throw new Error(`This did not come true: ${condition}`);
    await new Promise((resolve) => setTimeout(resolve, 30));
  }
}

export function stateOf(page, selector = 'ray-caster') {
  return page.evaluate((which) => document.querySelector(which).state, selector);
}

// Runs in the page before its scripts, and sets window.watch:
//
//     pending    what is scheduled and has not run yet: 'setTimeout 7' -> where it was scheduled
//     calls      how many times something was scheduled
//     compiled   how many WebAssembly programs were compiled
//     memories   weak references to the memories of their instances
export function watchPage() {
  const watch = { calls: 0, pending: new Map(), compiled: 0, memories: [] };
  window.watch = watch;
  const wrap = (name, cancel, repeats = false) => {
    const original = window[name].bind(window);
    const drop = window[cancel].bind(window);
    window[name] = (act, ...more) => {
      watch.calls += 1;
      const run =
        typeof act !== 'function'
          ? act
          : (...values) => {
              if (!repeats) watch.pending.delete(`${name} ${id}`);
              return act(...values);
            };
      const id = original(run, ...more);
      watch.pending.set(`${name} ${id}`, new Error().stack);
      return id;
    };
    window[cancel] = (id) => {
      watch.pending.delete(`${name} ${id}`);
      drop(id);
    };
  };
  wrap('requestAnimationFrame', 'cancelAnimationFrame');
  wrap('requestIdleCallback', 'cancelIdleCallback');
  wrap('setTimeout', 'clearTimeout');
  wrap('setInterval', 'clearInterval', true);
  for (const name of ['compile', 'compileStreaming', 'instantiateStreaming']) {
    const original = WebAssembly[name].bind(WebAssembly);
    WebAssembly[name] = (...values) => {
      watch.compiled += 1;
      return original(...values);
    };
  }
  const instantiate = WebAssembly.instantiate.bind(WebAssembly);
  WebAssembly.instantiate = async (program, imports) => {
    if (!(program instanceof WebAssembly.Module)) watch.compiled += 1;
    const made = await instantiate(program, imports);
    const { exports } = made.instance ?? made;
    const memory = Object.values(exports).find((value) => value instanceof WebAssembly.Memory);
    // The program's later part uses that of the first one
    if (memory !== undefined) watch.memories.push(new WeakRef(memory));
    return made;
  };
}

// The processor time that each process of the browser has used: [{id, type, cpuTime in seconds}].
export async function processorSeconds(browser) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  await session.detach();
  return processInfo;
}

export function wait(milliseconds) {
  return new Promise((resolve) => setTimeout(resolve, milliseconds));
}
