// The ways of the chosen tool as a small row of buttons over the view, and the end of what takes
// several clicks. Takes an editor; gives choices.
//
//     new ToolWays(row, editor);

import { iconOf } from './tool-icons.js';

export class ToolWays {
  #row;
  #editor;

  constructor(row, editor) {
    this.#row = row;
    this.#editor = editor;
    editor.listen((what) => what === 'choice' && this.#show());
    this.#show();
  }

  #show() {
    const { tool, way, pending } = this.#editor;
    const ways = tool.ways ?? [];
    this.#row.hidden = ways.length === 0 || tool.hasSelection === true; // whose bar has them
    if (this.#row.dataset.tool !== tool.name) {
      this.#row.dataset.tool = tool.name;
      this.#row.setAttribute('aria-label', `${tool.label}: what it makes`);
      this.#row.replaceChildren(...ways.map((one) => this.#button(one)), this.#done());
    }
    for (const button of this.#row.querySelectorAll('[data-way]'))
      button.setAttribute('aria-pressed', String(button.dataset.way === way));
    this.#row.querySelector('.done').hidden = pending === null || pending.kind !== 'way';
  }

  #button(way) {
    const { tool } = this.#editor;
    const button = document.createElement('button');
    button.type = 'button';
    button.dataset.way = way;
    const label = way[0].toUpperCase() + way.slice(1);
    button.title = [`${label} (O)`, tool.waysAbout?.[way]].filter(Boolean).join('. ');
    const words = document.createElement('span');
    words.textContent = label;
    button.append(iconOf(way), words);
    button.addEventListener('click', () => this.#editor.choose({ way }));
    return button;
  }

  #done() {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'done main';
    button.title = 'The way ends here (Enter)';
    button.textContent = 'Done';
    button.addEventListener('click', () => this.#editor.finish());
    return button;
  }
}
