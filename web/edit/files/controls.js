// Small parts of dialogs. Takes values and what to do; gives elements. Knows no document.
//
//     element('p', { className: 'soft' }, 'words', otherElement)
//     words('brick', '12 times')
//     select('What it becomes', choices, get, set)
//     numberField('Level', 'of the walls', { min, max, step }, get, set)
//
// Choices are [[value, words]] or, in groups, [[title, [[value, words]]]], or a function that gives
// them. The last two give { node, update }: update() shows what get() says now.

export function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

export function words(name, about) {
  const title = element('b', { title: name }, name);
  const more = about === '' ? [] : [element('span', { className: 'soft' }, about)];
  return element('span', { className: 'words' }, title, ...more);
}

export function select(label, choices, get, set) {
  const node = element('select', { title: label });
  node.setAttribute('aria-label', label);
  node.addEventListener('change', () => set(node.value));
  const listOf = typeof choices === 'function' ? choices : () => choices;
  let shown = '';
  const update = () => {
    const list = listOf();
    const said = JSON.stringify(list);
    if (said !== shown) node.replaceChildren(...list.map(optionOf));
    shown = said;
    node.value = get();
  };
  return { node, update };
}

function optionOf([value, inside]) {
  if (!Array.isArray(inside)) return new Option(inside, value);
  return element(
    'optgroup',
    { label: value },
    ...inside.map(([one, text]) => new Option(text, one)),
  );
}

// An empty field is null.
export function numberField(label, of, limits, get, set) {
  const input = element('input', { type: 'number', inputMode: 'decimal', ...limits });
  input.setAttribute('aria-label', `${label} ${of}`);
  input.addEventListener('change', () => {
    const number = input.value === '' ? null : Number(input.value);
    set(number === null ? null : Math.min(limits.max, Math.max(limits.min, number)));
  });
  const node = element('label', { className: 'number' }, label, input);
  return { node, update: () => (input.value = get() ?? '') };
}
