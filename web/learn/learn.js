// A chapter's page: starts its figures, follows their numbers in the text, checks answers to
// exercises, loads the panel of the reader's raycaster when it comes near, and the search.
//
//     startPage({ figures: { walk } });

import { mount } from './figures/mount.js';
import { startProgress } from './progress.js';
import { startReplies } from './replies.js';
import { startSearch } from './search.js';

const kNear = '600px'; // how far from the window the panel begins to load

export function startPage({ figures }) {
  for (const [name, figure] of Object.entries(figures)) {
    const element = document.getElementById(name);
    if (element === null) continue;
    const onNow = (now, numbers) => show(name, numbers);
    mount(element, figure, { name, scenes: new URL('scenes/', document.baseURI), onNow });
  }
  startReplies(document);
  startProgress();
  startSearch();
  const panel = document.querySelector('.write');
  if (panel !== null) whenNear(panel, () => startPanel(panel));
}

// Puts a figure's numbers into the text.
function show(name, numbers) {
  for (const output of document.querySelectorAll(`output[data-number^="${name}."]`)) {
    const value = numbers[output.dataset.number.slice(name.length + 1)];
    if (value !== undefined && output.innerHTML !== value) output.textContent = value;
  }
}

function whenNear(element, begin) {
  const watch = new IntersectionObserver(
    (entries) => {
      if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
      watch.disconnect();
      begin();
    },
    { rootMargin: kNear },
  );
  watch.observe(element);
}

async function startPanel(element) {
  const { mountPanel } = await import('./write/panel.js');
  mountPanel(element);
}
