// The ways of the chosen tool as a small row of buttons over the view, the end of what takes some
// clicks, and a switch that removes, for fingers, which have no right button.
// Takes an editor; gives choices.
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
    const { tool, way, pending, removes, isTouch } = this.#editor;
    const ways = tool.ways ?? [];
    const hasSwitch = tool.canRemove === true && (isTouch || removes);
    const hasOwnBar = tool.hasSelection === true;
    this.#row.hidden = (ways.length === 0 && !hasSwitch) || hasOwnBar;
    if (this.#row.dataset.tool !== tool.name) {
      this.#row.dataset.tool = tool.name;
      this.#row.setAttribute('aria-label', `${tool.label}: what it makes`);
      this.#row.replaceChildren(
        ...ways.map((one) => this.#button(one)),
        this.#switch(),
        this.#done(),
      );
    }
    for (const button of this.#row.querySelectorAll('[data-way]'))
      button.setAttribute('aria-pressed', String(button.dataset.way === way));
    const removing = this.#row.querySelector('.removes');
    removing.hidden = !hasSwitch;
    removing.setAttribute('aria-pressed', String(removes));
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

  #switch() {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'removes';
    button.title = 'Take away instead of putting';
    button.append(iconOf('removes'), 'Remove');
    button.addEventListener('click', () => this.#editor.choose({ removes: !this.#editor.removes }));
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
