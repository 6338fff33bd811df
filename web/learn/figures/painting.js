// Paints the cells of a map in a live figure: by the pointer, or typed at a cell cursor.
//
// It loads with the few figures that are painted, and imports nothing, so that the kit
// stays one file.

export class Painting {
  #figure;
  #paint;
  #box = null; // of the drawing
  #stroke = '.'; // what the stroke under way puts

  // `figure`: {state, now, change(change)}; `paint` is that of the view.
  constructor(figure, paint) {
    this.#figure = figure;
    this.#paint = paint;
  }

  // `onPick` is that of handles.js; `inDrawing` turns points of `body` into points of the drawing.
  listen(body, onPick, inDrawing) {
    body.classList.add('picks');
    body.addEventListener('click', ({ target }) => {
      const { brush } = target.closest('[data-brush]')?.dataset ?? {};
      if (brush !== undefined) this.#figure.change({ brush });
    });
    onPick(body, (point, isFirst) => this.#figure.change(this.#put(inDrawing(point), isFirst)));
  }

  // The cell cursor is a handle: it moves by arrows, and what is typed goes into its cell.
  cursor(now, box) {
    this.#box = box;
    const paint = this.#paint;
    const cell = now.state.cell ?? paint.startCell(now, box);
    const character = paint.characterAt(cell, now);
    const blocks = paint.blocksOf(now);
    const name = (sign) => blocks.find((block) => block.character === sign)?.name ?? 'empty';
    const brush = this.#brush(now);
    const put = (sign) => ({ ...paint.edited(cell, sign, now), cell });
    return {
      id: 'cell',
      label: `Cell to paint with ${name(brush)}`,
      ...paint.middleOf(cell, now, box),
      value: cell[0],
      least: 0,
      greatest: now.map(now.eye.map).width - 1,
      says: `${cell.join(', ')}: ${name(character)}`,
      isDirect: true,
      drag: (point, _, start, isFirst) => this.#put(point, isFirst),
      keys: (right, down) => ({ cell: paint.within([cell[0] + right, cell[1] + down], now, box) }),
      press(key) {
        if (key === 'Enter' || key === ' ') return put(character === brush ? '.' : brush);
        if (key === 'Delete' || key === 'Backspace') return put('.');
        return blocks.some((block) => block.character === key) ? put(key) : undefined;
      },
    };
  }

  #brush(now) {
    return now.state.brush ?? this.#paint.blocksOf(now)[0].character;
  }

  // The change of a stroke over a point. One that begins on the brush's own block erases.
  #put(point, isFirst) {
    const paint = this.#paint;
    const { now } = this.#figure;
    const cell = paint.cellAt(point, now, this.#box);
    if (cell === null) return null;
    const brush = this.#brush(now);
    const before = paint.characterAt(cell, now);
    if (isFirst) this.#stroke = before === brush ? '.' : brush;
    return before === this.#stroke ? { cell } : { ...paint.edited(cell, this.#stroke, now), cell };
  }
}
