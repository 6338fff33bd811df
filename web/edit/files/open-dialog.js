// The dialog that opens another world: a template, a shipped scene, or a file.
// Gives addresses to the browser: each world has one, so that going back works.

import { kHome } from '../../engine/home.js';
import { templates } from './templates.js';

export function openDialog(dialog, button) {
  let isFilled = false;
  button.addEventListener('click', async () => {
    dialog.showModal();
    if (isFilled) return;
    isFilled = true;
    dialog
      .querySelector('#templates')
      .append(...templates.map(({ name, title }) => card(title, `?template=${name}`, null)));
    const scenes = await fetch(new URL('scenes/index.json', kHome)).then((answer) => answer.json());
    dialog.querySelector('#remixes').append(
      ...scenes.map(({ file, title }) => {
        const name = file.replace('.json', '');
        return card(title, `?scene=${name}`, new URL(`scenes/${name}.png`, kHome));
      }),
    );
  });
}

function card(title, query, picture) {
  const item = document.createElement('li');
  const button = document.createElement('button');
  button.type = 'button';
  if (picture !== null) {
    const image = document.createElement('img');
    Object.assign(image, { src: picture.href, alt: '', loading: 'lazy' });
    button.append(image);
  }
  button.append(title);
  button.addEventListener('click', () =>
    location.assign(new URL(query, location.pathname, location.href)),
  );
  item.append(button);
  return item;
}
