// Shared by the tests of <ray-caster>: a page with elements in it, and questions to them.
//
//     const { page } = await openElements(t, browser,
//       '<ray-caster id="a" scene="room"></ray-caster>');
//     await ready(page, 'a');

import { openPage } from './browser.mjs';

const kWaitMilliseconds = 10000;

// The body's markup; `head` goes before the element's script, which is a module unless `script`
// says otherwise.
export function openElements(
  t,
  browser,
  markup,
  {
    head = '',
    script = '<script type="module" src="ray-caster.js"></script>',
    files = {},
    ...options
  } = {},
) {
  const html = `<!doctype html><html lang="en"><meta charset="utf-8"><title>Host</title><link rel="icon" href="favicon.svg">
    <meta name="viewport" content="width=device-width"><style>body { margin: 0 } ray-caster { width: 320px }</style>${head}${script}<body>${markup}</body></html>`;
  return openPage(t, browser, {
    query: 'host.html',
    server: { files: { 'host.html': html, ...files } },
    ...options,
  });
}

// The result of whenReady(), or the error that it rejects with.
export function ready(page, id) {
  return page.evaluate(
    ([which, wait]) =>
      Promise.race([
        customElements
          .whenDefined('ray-caster')
          .then(() => document.getElementById(which).whenReady()),
        new Promise((_, reject) =>
          setTimeout(() => reject(new Error('neither ready nor an error')), wait),
        ),
      ]).catch(({ code, title, message, faults }) => ({ code, title, message, faults })),
    [id, kWaitMilliseconds],
  );
}

export function inElementState(page, id, state) {
  return page.waitForFunction(
    ([which, wanted]) => document.getElementById(which).state === wanted,
    [id, state],
  );
}

// A pixel of the picture as it is on the canvas, after the frame that may still be under way.
export function elementPixel(page, id, shareX = 0.5, shareY = 0.5) {
  return page.evaluate(
    async ([which, x, y]) => {
      await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
      const canvas = document.getElementById(which).shadowRoot.querySelector('canvas');
      return [
        ...canvas
          .getContext('2d')
          .getImageData(Math.floor(x * canvas.width), Math.floor(y * canvas.height), 1, 1)
          .data.subarray(0, 3),
      ];
    },
    [id, shareX, shareY],
  );
}

// What has the focus: the element's id, and the piece inside it.
export function focusOf(page) {
  return page.evaluate(() => {
    const { activeElement } = document;
    const inside = activeElement.shadowRoot?.activeElement;
    return inside
      ? `${activeElement.id} ${inside.dataset.name ?? (inside.classList[0] || inside.localName)}`
      : activeElement.id || activeElement.localName;
  });
}

// Begins to note events of an element; eventsOf gives them as [name, detail].
export function noteEvents(page, id, names) {
  return page.evaluate(
    ([which, wanted]) => {
      window.noted ??= {};
      window.noted[which] = [];
      for (const name of wanted)
        document
          .getElementById(which)
          .addEventListener(name, ({ detail }) => window.noted[which].push([name, { ...detail }]));
    },
    [id, names],
  );
}

export function eventsOf(page, id) {
  return page.evaluate((which) => window.noted[which], id);
}
