// The list of what is wrong with the scene; each entry leads to its place in the text.
// Takes faults and warnings as <ray-caster> gives them. Changes nothing.
//
//     const problems = new Problems(section, (fault) => ...);
//     problems.show(faults, warnings);

const kMost = 30;

export class Problems {
  #section;
  #goTo;

  constructor(section, goTo) {
    this.#section = section;
    this.#goTo = goTo;
  }

  show(faults, warnings) {
    const all = [...faults, ...warnings];
    this.#section.hidden = all.length === 0;
    this.#section.querySelector('h2').textContent =
      faults.length > 0 ? 'To mend' : 'Probable mistakes';
    this.#section.querySelector('ul').replaceChildren(
      ...all.slice(0, kMost).map((fault) => {
        const button = document.createElement('button');
        button.type = 'button';
        const { pointer, found, expected } = fault;
        button.textContent = `${placeOf(pointer)}: ${expected === '' ? found : `found ${found}, expected ${expected}`}`;
        button.addEventListener('click', () => this.#goTo(fault));
        const item = document.createElement('li');
        item.append(button);
        return item;
      }),
    );
  }
}

// "/blueprints/low wall/top" -> "low wall, top"
function placeOf(pointer) {
  const parts = pointer
    .split('/')
    .slice(1)
    .map((part) => part.replaceAll('~1', '/').replaceAll('~0', '~'));
  return parts.slice(-2).join(', ') || 'the scene';
}
