// The menu of scenes: a card for each, with its first view and links to the editor and, if there is
// one, to its tour.
//
//     const menu = new SceneMenu(dialog, scenes, {missing, addressOf, onChoose});
//     menu.open('castle.json');      the current scene

import { editAddress, posterAddress } from './scene-list.js';

export class SceneMenu {
  // `scenes` is the list of scene-list.js; `missing` is the Trouble if it could not be loaded, else
  // null; `addressOf(file)` is the page's address of a scene; `onChoose(file)` opens it in place.
  constructor(dialog, scenes, { missing, addressOf, onChoose }) {
    this.dialog = dialog;
    this.cards = scenes.map((scene) => ({ scene, ...card(scene, addressOf(scene.file)) }));
    for (const { link, scene } of this.cards) {
      link.addEventListener('click', (event) => {
        // The browser opens new tabs and windows.
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

// The title before the first scene of a group.
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
  // The size reserves the space until the picture has loaded.
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
  const ways = document.createElement('div');
  ways.className = 'ways';
  if (scene.tour) {
    const name = encodeURIComponent(scene.file.replace(/\.json$/i, ''));
    ways.append(way('tour', `?tour=${name}`, 'Take the tour', scene));
  }
  ways.append(way('edit', editAddress(scene.file), 'Edit', scene));
  item.append(link, ways);
  return { item, link };
}

function way(kind, address, text, { title }) {
  const link = document.createElement('a');
  link.className = kind;
  link.href = address;
  link.textContent = text;
  link.setAttribute('aria-label', `${text}: ${title}`);
  return link;
}
