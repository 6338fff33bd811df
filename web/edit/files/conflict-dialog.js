// The dialog for a file that has changed outside since it was read: both texts, the places that
// differ, and what to do. Takes texts; gives 'mine', 'theirs' or null.
//
//     const choose = conflictDialog(dialog, (text) => ...);    // the function saves a copy
//     await choose({ name: 'my.json', mine, theirs })

import { differencesOf } from './line-differences.js';

const kMostPlaces = 40;
const kMostLines = 12; // shown of a place
const kMostLetters = 160; // of a line

export function conflictDialog(dialog, saveCopy) {
  const find = (name) => dialog.querySelector(`[data-conflict=${name}]`);
  let mine = '';
  find('copy').addEventListener('click', async () => {
    const told = await saveCopy(mine);
    if (told !== null) find('told').textContent = told;
  });
  for (const choice of ['mine', 'theirs'])
    find(choice).addEventListener('click', () => dialog.close(choice));

  return (texts) => {
    ({ mine } = texts);
    const { name, theirs } = texts;
    const places = differencesOf(theirs, mine);
    find('about').textContent =
      `${name} has changed outside this page since it was read. ` +
      `It differs from what you have here in ${counted(places.length)}.`;
    find('told').textContent = '';
    find('places').replaceChildren(
      ...places.slice(0, kMostPlaces).flatMap(({ one, other }) => [half(one), half(other)]),
    );
    find('rest').hidden = places.length <= kMostPlaces;
    find('rest').textContent = `And ${counted(places.length - kMostPlaces)} more.`;
    const whole = find('whole');
    whole.open = false;
    whole.ontoggle = () => {
      find('whole-theirs').textContent = whole.open ? theirs : '';
      find('whole-mine').textContent = whole.open ? mine : '';
    };
    dialog.returnValue = '';
    dialog.showModal();
    return new Promise((resolve) => {
      dialog.addEventListener('close', () => resolve(dialog.returnValue || null), { once: true });
    });
  };
}

const counted = (places) => (places === 1 ? 'one place' : `${places} places`);

function half({ from, lines }) {
  const part = document.createElement('div');
  const where = document.createElement('p');
  where.className = 'soft figures';
  where.textContent =
    lines.length === 0
      ? `nothing, before line ${from}`
      : lines.length === 1
        ? `line ${from}`
        : `lines ${from} to ${from + lines.length - 1}`;
  const text = document.createElement('pre');
  const shown = lines.slice(0, kMostLines).map(cut);
  if (lines.length > kMostLines) shown.push('…');
  text.textContent = shown.join('\n');
  part.append(where, text);
  return part;
}

function cut(line) {
  return line.length > kMostLetters ? `${line.slice(0, kMostLetters)} …` : line;
}
