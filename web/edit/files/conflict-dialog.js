// The dialog for a file that has changed outside since it was read: both texts, the places that
// differ, and what to do. Takes texts; gives 'mine', 'theirs', 'both' or null.
//
//     const choose = conflictDialog(dialog, (text) => ...);    // the function saves a copy
//     await choose({ name: 'my.json', mine, theirs, both })    // no 'both' if that is null

import { differencesOf } from './line-differences.js';

const kMostPlaces = 40;
const kMostLines = 12; // shown of a place
const kMostLetters = 160; // of a line
const kBefore = 8; // letters of a line before those that differ

export function conflictDialog(dialog, saveCopy) {
  const find = (name) => dialog.querySelector(`[data-conflict=${name}]`);
  let mine = '';
  find('copy').addEventListener('click', async () => {
    const told = await saveCopy(mine);
    if (told !== null) find('told').textContent = told;
  });
  for (const choice of ['both', 'theirs', 'mine'])
    find(choice).addEventListener('click', () => dialog.close(choice));

  return (texts) => {
    ({ mine } = texts);
    const { name, theirs, both } = texts;
    const places = differencesOf(theirs, mine);
    find('about').textContent =
      `${name} has changed outside this page since it was read. ` +
      `It differs from what you have here in ${counted(places.length)}.`;
    find('both').hidden = both === null;
    find('fits').textContent =
      both === null
        ? 'Both have changed the same lines, so one of them must give way.'
        : 'Take both: the changes of the file and yours, which are in different lines.';
    find('told').textContent = '';
    find('places').replaceChildren(
      ...places
        .slice(0, kMostPlaces)
        .flatMap(({ one, other }) => [half(one, other), half(other, one)]),
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

function half({ from, lines }, other) {
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
  for (const [at, line] of lines.slice(0, kMostLines).entries())
    text.append(...(at > 0 ? ['\n'] : []), ...marked(line, other.lines[at] ?? ''));
  if (lines.length > kMostLines) text.append('\n…');
  part.append(where, text);
  return part;
}

// The line, from shortly before what differs from the other one.
function marked(line, other) {
  const most = Math.min(line.length, other.length);
  let begin = 0;
  while (begin < most && line[begin] === other[begin]) ++begin;
  let tail = 0;
  while (tail < most - begin && line.at(-1 - tail) === other.at(-1 - tail)) ++tail;
  const end = line.length - tail;
  const first = Math.max(0, begin - kBefore);
  const differs = document.createElement('mark');
  differs.textContent = cut(line.slice(begin, end));
  return [first > 0 ? '… ' : '', line.slice(first, begin), differs, cut(line.slice(end))];
}

function cut(text) {
  return text.length > kMostLetters ? `${text.slice(0, kMostLetters)} …` : text;
}
