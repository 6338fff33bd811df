// Lines of code, with those of the current step marked.

import { escape } from '../markup.js';
import { panel } from './own.js';

// `lines` maps the kinds of steps to line numbers from 1. `html`: lines that are coloured already.
export function codeView({ code = '', html, lines = {}, marked, first = 1, ...others } = {}) {
  const markedIn = marked ?? ((now) => lines[now.step?.kind] ?? []);
  return panel({
    ...others,
    markup: (now) => {
      const numbers = [markedIn(now)].flat();
      const list =
        html ??
        (typeof code === 'function' ? code(now) : code).replace(/\n$/, '').split('\n').map(escape);
      const written = list.map((text, index) => {
        const isNow = numbers.includes(index + first);
        return `<span class="fig-line${isNow ? ' now' : ''}"${isNow ? ' aria-current="step"' : ''}><span class="fig-line-number" aria-hidden="true">${index + first}</span>${text || ' '}</span>`;
      });
      const title = typeof others.title === 'string' ? others.title : 'Code';
      return `<pre class="fig-code" tabindex="0" role="region" aria-label="${escape(title)}"><code>${written.join('')}</code></pre>`;
    },
  });
}
