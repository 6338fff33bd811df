// The menu of scenes: a card for each, with its view from the start and the way to its tour where it
// has one.
//
//     const menu = new SceneMenu(dialog, scenes, {missing, addressOf, onChoose});
//     menu.open('castle.json');      the scene that is shown

import { posterAddress } from './scene-list.js';

export class SceneMenu {
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
    const items = this.cards.flatMap(({ scene, item }, i) =>
      (scene.group ?? '') === (scenes[i - 1]?.group ?? '') ? [item] : [groupTitle(scene), item],
    );
    dialog.querySelector('ul').replaceChildren(...items);
  }

  open(current) {
    for (const { link, scene } of this.cards) {
      if (scene.file === current) link.setAttribute('aria-current', 'true');
      else link.removeAttribute('aria-current');
    }
    this.dialog.showModal();
  }
}

// Stands before the first of the scenes that the list sets apart.
function groupTitle({ group }) {
  const item = document.createElement('li');
  item.className = 'group';
  item.textContent = group;
  return item;
}

function card(scene, address) {
  const item = document.createElement('li');
  const link = document.createElement('a');
  link.className = 'scene';
  link.href = address;
  // Its place is held until it is there.
  const view = document.createElement('img');
  Object.assign(view, { alt: '', width: 480, height: 270, loading: 'lazy' });
  if (scene.poster !== undefined) {
    view.addEventListener('error', () => view.removeAttribute('src'), { once: true });
    view.src = posterAddress(scene.poster).href;
  }
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
  return { item, link };
}
