// The dialog with what one slice of the picture meets, as text: the inspected one, else the middle.
//
//     const slice = new SliceDialog(dialog, caster);
//     slice.open();

export class SliceDialog {
  #dialog;
  #caster;

  constructor(dialog, caster) {
    this.#dialog = dialog;
    this.#caster = caster;
  }

  open() {
    const { width } = this.#caster.picture;
    const chosen = Number(this.#caster.get('inspectorColumn'));
    const column = chosen >= 0 && chosen < width ? chosen : Math.floor(width / 2);
    const slice = this.#caster.hits(column);
    this.#dialog.querySelector('h2').textContent = `Slice ${column} of ${width}`;
    this.#dialog.querySelector('tbody').replaceChildren(...linesOf(slice).map(row));
    this.#dialog.showModal();
  }
}

// From the picture's top to its bottom: {first, last, what, where, depth, heights}.
function linesOf({ hits, planes, objects, portals, mirrors }) {
  const lines = [
    ...hits.flatMap(({ filled, blueprint, tile, level, depth, bottom, top }) =>
      filled.map(({ what, face, first, last }) => ({
        first,
        last,
        what: `${blueprint}, ${face === null || face === what ? what : `${face} ${what}`}`,
        where: `tile ${tile.join(', ')}; level ${level}`,
        depth,
        heights: [bottom, top],
      })),
    ),
    ...planes.map(({ what, map, first, last }) => ({ first, last, what, where: map })),
    ...objects.map(({ sprite, point, bottom, top, depth, first, last }) => ({
      first,
      last,
      what: sprite,
      where: `at ${point.map((number) => number.toFixed(2)).join(', ')}`,
      depth,
      heights: [bottom, top],
    })),
    ...portals.map(({ from, to, depth, first, last }) => ({
      first,
      last,
      what: 'portal',
      where: `tile ${from.tile.join(', ')}; to ${to.map}, tile ${to.tile.join(', ')}`,
      depth,
    })),
    ...mirrors.map(({ map, height, first, last }) => ({
      first,
      last,
      what: 'mirror',
      where: map,
      heights: [height],
    })),
  ];
  return lines.sort((a, b) => a.first - b.first || a.last - b.last);
}

function row({ first, last, what, where, depth, heights = [] }) {
  const texts = [
    first === last ? `${first}` : `${first} to ${last}`,
    what,
    where,
    Number.isFinite(depth) ? depth.toFixed(2) : '',
    heights.map((height) => Number(height.toFixed(2))).join(' to '),
  ];
  const element = document.createElement('tr');
  element.append(
    ...texts.map((text, index) => {
      const cell = document.createElement(index === 0 ? 'th' : 'td');
      if (index === 0) cell.scope = 'row';
      cell.textContent = text;
      return cell;
    }),
  );
  return element;
}
