// Formulas as MathML, by Temml. The pages' policy forbids inline styles, so what Temml writes as
// such becomes classes; `styles` has their rules, and Temml's own.

import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import temml from 'temml';

const kMacros = { '\\x': '\\class{across}{#1}', '\\y': '\\class{along}{#1}' };
const kFont = /@font-face \{[^}]*\}/g; // for script letters, which the tutorial does not use

export class Formulas {
  #classes = new Map(); // declarations -> class

  mathMl(formula, isBlock) {
    // Names of several letters stand upright: fonts space the letters of mathematical italics as if
    // they were to be multiplied.
    const math = temml.renderToString(formula.replaceAll('\\mathit{', '\\mathrm{'), {
      displayMode: isBlock,
      trust: true, // for \class
      throwOnError: true,
      macros: { ...kMacros },
    });
    return math.replaceAll(/<[^<>]* style="[^"]*"[^<>]*>/g, (tag) => {
      const [whole, declarations] = / style="([^"]*)"/.exec(tag);
      const plain = tag.replace(whole, '');
      const name = this.#classOf(declarations);
      return / class="/.test(plain)
        ? plain.replace(' class="', ` class="${name} `)
        : plain.replace(/(?=\/?>$)/, ` class="${name}"`);
    });
  }

  get styles() {
    const require = createRequire(import.meta.url);
    const folder = path.dirname(require.resolve('temml'));
    const rules = readFileSync(path.join(folder, 'Temml-Local.css'), 'utf8').replaceAll(kFont, '');
    const own = [...this.#classes].map(([declarations, name]) => `.${name} { ${declarations} }\n`);
    return rules + own.join('');
  }

  #classOf(declarations) {
    if (!this.#classes.has(declarations))
      this.#classes.set(declarations, `math-${this.#classes.size}`);
    return this.#classes.get(declarations);
  }
}
