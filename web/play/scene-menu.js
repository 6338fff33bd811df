// The menu of scenes: a card for each, with its view from the start, which the engine draws when
// the menu is opened for the first time, and the way to its tour where it has one.

import { sceneAt } from './scene-source.js';

const kAspect = 9 / 16; // of a view

export class SceneMenu {
  #drawn = false;

  // `scenes` as in the list that comes with the page; `missing` is a Trouble where there is none;
  // `addressOf(file)` is the page's address with that scene; `onChoose(file)` opens it here.
  constructor(dialog, scenes, { missing, addressOf, onChoose }) {
    this.dialog = dialog;
    this.cards = scenes.map((scene) => ({ scene, ...card(scene, addressOf(scene.file)) }));
    for (const { link, scene } of this.cards) {
      link.addEventListener('click', (event) => {
        // A new tab or window is the browser's affair.
        if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
        event.preventDefault();
        dialog.close();
        onChoose(scene.file);
      });
    }
    const hint = dialog.querySelector('.missing');
    hint.hidden = missing === null;
    hint.textContent = missing === null ? '' : `${missing.title}. ${missing.message}`;
    dialog.querySelector('ul').replaceChildren(...this.cards.map(({ item }) => item));
  }

  // `current` is the file that is open, `engine` may be null.
  async open(engine, current) {
    for (const { link, scene } of this.cards) {
      if (scene.file === current) link.setAttribute('aria-current', 'true');
      else link.removeAttribute('aria-current');
    }
    this.dialog.showModal();
    if (this.#drawn || engine === null) return;
    this.#drawn = true;
    for (const { scene, view } of this.cards) {
      // As many pixels as the screen has there.
      view.width = Math.max(1, Math.round(view.clientWidth * window.devicePixelRatio));
      view.height = Math.max(1, Math.round(view.width * kAspect));
      const picture = await engine
        .drawAside(sceneAt(scene.file), view.width, view.height)
        .catch(() => null);
      if (picture !== null) view.getContext('2d').putImageData(picture, 0, 0);
    }
  }
}

function card(scene, address) {
  const item = document.createElement('li');
  const link = document.createElement('a');
  link.className = 'scene';
  link.href = address;
  const view = document.createElement('canvas');
  view.setAttribute('aria-hidden', 'true');
  const title = document.createElement('h3');
  title.textContent = scene.title;
  const about = document.createElement('p');
  about.textContent = scene.about;
  link.append(view, title, about);
  item.append(link);
  if (scene.tour) {
    const tour = document.createElement('a');
    tour.className = 'tour';
    tour.href = `?tour=${encodeURIComponent(scene.file.replace(/\.json$/i, ''))}`;
    tour.textContent = 'Take the tour';
    tour.setAttribute('aria-label', `Take the tour: ${scene.title}`);
    item.append(tour);
  }
  return { item, link, view };
}
