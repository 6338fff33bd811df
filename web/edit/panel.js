// The panel at the side: tabs for the chosen block, the chosen thing, the map and the world, each
// with a form. Takes an editor and the schema; the forms give changes to the history.
//
//     const panel = new Panel(editor, schema);
//     panel.show({ sign: '#' });   // after another choice
//     panel.showTab('map');

import { SchemaForm } from './forms/schema-form.js';
import { copyOf } from './handles.js';
import { kindOf } from './kinds.js';

const kTabs = ['kind', 'thing', 'map', 'world'];
// What other parts of the page show already
const kLeaveOut = {
  kind: ['faces', 'top', 'bottom'],
  map: ['objects'],
  world: ['title', 'maps'],
};
const byId = (id) => document.getElementById(id);

export class Panel {
  #editor;
  #forms;

  constructor(editor, schema) {
    this.#editor = editor;
    this.#forms = kTabs.map((tab) => {
      const place = byId(`part-${tab}`).querySelector('.form');
      return new SchemaForm(place, editor, schema, { leaveOut: kLeaveOut[tab] });
    });
    for (const tab of kTabs) byId(`tab-${tab}`).addEventListener('click', () => this.showTab(tab));
    byId('tabs').addEventListener('keydown', ({ key }) => this.#move(key));
    this.showTab('kind');
  }

  showTab(wanted) {
    for (const tab of kTabs) {
      byId(`part-${tab}`).hidden = tab !== wanted;
      byId(`tab-${tab}`).setAttribute('aria-selected', String(tab === wanted));
      byId(`tab-${tab}`).tabIndex = tab === wanted ? 0 : -1;
    }
    this.#fill();
  }

  // What was touched or chosen comes to the front: a thing, another tool, another block.
  show({ edited = null, sign, tool } = {}) {
    if (edited !== null || tool?.hasThings) this.showTab('thing');
    else if (sign !== undefined || tool !== undefined) this.showTab('kind');
    else this.#fill();
  }

  #move(key) {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[key];
    if (step === undefined) return;
    const shown = kTabs.findIndex((tab) => !byId(`part-${tab}`).hidden);
    const next = kTabs[(shown + step + kTabs.length) % kTabs.length];
    this.showTab(next);
    byId(`tab-${next}`).focus();
  }

  #fill() {
    const { scene, map, sign, edited } = this.#editor;
    const kind = kindOf(scene, map, sign);
    byId('part-thing').querySelector('p').hidden = edited !== null;
    byId('thing-acts').hidden = edited === null || edited[0] === 'start';
    byId('thing-copy').hidden = edited !== null && copyOf(scene, edited) === null;
    const paths = [kind === null ? null : ['blueprints', kind.name], edited, ['maps', map], []];
    this.#forms.forEach((form, index) => form.show(paths[index]));
  }
}
