// The sheet that shows an error. Escape goes back, where there is a picture to go back to.
//
//     sheet.show({title, message, faults}, {again, scenes, back});      the event `error`'s detail
//     sheet.near(meant);

const kActions = ['again', 'scenes', 'back'];

export class TroubleSheet {
  constructor(root) {
    this.root = root;
    this.find = (name) => root.querySelector(`#trouble-${name}`);
    this.actions = {};
    for (const name of kActions)
      this.find(name).addEventListener('click', () => this.actions[name]());
    document.addEventListener('keydown', ({ key, defaultPrevented }) => {
      const isShown = !root.hidden && !this.find('back').hidden;
      if (
        key === 'Escape' &&
        isShown &&
        !defaultPrevented &&
        !document.querySelector('dialog[open]')
      )
        this.actions.back();
    });
  }

  // `actions` are {again, scenes, back}: functions, or null to hide a button.
  show(trouble, actions) {
    this.actions = actions;
    this.find('title').textContent = trouble.title;
    this.find('text').textContent = trouble.message;
    this.find('faults').hidden = trouble.faults.length === 0;
    this.root.classList.toggle('has-faults', trouble.faults.length > 0);
    this.root.querySelector('tbody').replaceChildren(...trouble.faults.map(faultRow));
    for (const name of kActions) this.find(name).hidden = actions[name] === null;
    this.find('actions').hidden = false;
    this.root.hidden = false;
  }

  // Suggests the scene that was probably meant (nearOf); null for none.
  near(meant) {
    const line = this.find('near');
    line.hidden = meant === null;
    if (meant === null) return;
    const link = Object.assign(document.createElement('a'), {
      href: meant.query,
      textContent: `Open ${meant.name}`,
    });
    line.replaceChildren(`${meant.message} `, link);
  }

  hide() {
    this.root.hidden = true;
  }
}

// The place inside the scene: a JSON pointer and, in a grid of characters, the tile.
function insideOf({ pointer, row, character }) {
  const tile = [row >= 0 ? `row ${row}` : '', character >= 0 ? `character ${character}` : '']
    .filter((part) => part !== '')
    .join(', ');
  return tile === '' ? pointer : `${pointer}, ${tile}`;
}

function faultRow(fault) {
  const row = document.createElement('tr');
  const place = document.createElement('th');
  place.scope = 'row';
  place.textContent = fault.place;
  const inside = insideOf(fault);
  if (inside !== '') {
    const where = document.createElement('span');
    where.className = 'inside';
    where.textContent = inside;
    place.append(where);
  }
  const found = document.createElement('td');
  found.className = 'found';
  found.dataset.label = 'Found';
  found.textContent = fault.found;
  const expected = document.createElement('td');
  expected.dataset.label = 'Expected';
  expected.textContent = fault.expected;
  row.append(place, found, expected);
  return row;
}
