// The search in the head of each page. The index, search.json, and the library that reads it are
// loaded when somebody first goes to the field.

const kMost = 12; // results

export function startSearch() {
  const input = document.getElementById('search');
  const list = document.getElementById('found');
  if (input === null) return;
  let finder = null;
  let selected = -1;

  const links = () => [...list.querySelectorAll('a')];
  const close = () => {
    list.hidden = true;
    input.setAttribute('aria-expanded', 'false');
    input.removeAttribute('aria-activedescendant');
    selected = -1;
  };
  const select = (index) => {
    const items = [...list.querySelectorAll('[role=option]')];
    if (items.length === 0) return;
    selected = (index + items.length) % items.length;
    items.forEach((item, at) => item.setAttribute('aria-selected', String(at === selected)));
    items[selected].scrollIntoView({ block: 'nearest' });
    input.setAttribute('aria-activedescendant', items[selected].id);
  };
  const search = async () => {
    finder ??= loadFinder();
    const words = input.value.trim();
    if (words === '') return close();
    const found = await finder.then(
      (index) => index.search(words).slice(0, kMost),
      () => null,
    );
    if (input.value.trim() !== words) return;
    list.replaceChildren(...itemsOf(found));
    list.hidden = false;
    input.setAttribute('aria-expanded', 'true');
    selected = -1;
  };

  input.addEventListener('focus', () => (finder ??= loadFinder()).catch(() => {}), { once: true });
  input.addEventListener('input', search);
  input.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') close();
    else if (event.key === 'ArrowDown' && !list.hidden) select(selected + 1);
    else if (event.key === 'ArrowUp' && !list.hidden) select(selected - 1);
    else if (event.key === 'Enter' && !list.hidden) links()[Math.max(0, selected)]?.click();
    else return;
    if (event.key !== 'Escape') event.preventDefault();
  });
  list.addEventListener('mousedown', (event) => event.preventDefault());
  input.addEventListener('blur', close);
}

async function loadFinder() {
  const [{ default: MiniSearch }, answer] = await Promise.all([
    import('minisearch'),
    fetch(new URL('../search.json', import.meta.url)),
  ]);
  if (!answer.ok) throw new Error(`search.json: ${answer.status}`);
  return MiniSearch.loadJSON(await answer.text(), {
    fields: ['title', 'chapter', 'text'],
    storeFields: ['title', 'chapter', 'address'],
    searchOptions: { prefix: true, fuzzy: 0.2, boost: { title: 4, chapter: 2 } },
  });
}

function itemsOf(found) {
  if (found === null) return [paragraph('The search could not be loaded.')];
  if (found.length === 0) return [paragraph('Nothing found.')];
  return found.map(({ title, chapter, address }, index) => {
    const item = document.createElement('li');
    item.role = 'option';
    item.id = `found-${index}`;
    const link = document.createElement('a');
    link.href = address;
    link.tabIndex = -1;
    const [name, where] = [document.createElement('b'), document.createElement('span')];
    name.textContent = title;
    where.textContent = chapter;
    link.append(name, where);
    item.append(link);
    return item;
  });
}

function paragraph(text) {
  const item = document.createElement('li');
  const words = document.createElement('p');
  words.textContent = text;
  item.append(words);
  return item;
}
