// Rows of the Lab: a label and what sets an option of the engine. What each can be follows from the
// engine's own table of options.
//
//     const row = optionRow(spec, { read, write });     read(name) -> text, write(name, text)
//     row.element, row.show(options)                    as the engine has it now, by name

const kColumns = ['inspectorColumn', 'drawnColumns']; // ranges that end with the picture

// {option, label, least, greatest, step, shown(value)}; a switch, a choice or a slider, as the
// option's kind wants it.
export function optionRow(spec, actions) {
  const element = document.createElement('p');
  element.className = 'lab-row';
  const label = document.createElement('label');
  const id = `lab-${spec.option}`;
  Object.assign(label, { textContent: spec.label, htmlFor: id });
  const { field, show } = fieldFor(spec, actions);
  (field.matches('input, select') ? field : field.querySelector('input')).id = id;
  element.append(label, field);
  return { element, show: (options) => show(options.get(spec.option)) };
}

function fieldFor(spec, actions) {
  if (spec.choices) return choice(spec, actions);
  return spec.greatest === undefined ? toggle(spec, actions) : slider(spec, actions);
}

function toggle({ option }, { write }) {
  const field = document.createElement('input');
  Object.assign(field, { type: 'checkbox', className: 'switch' });
  field.addEventListener('input', () => write(option, field.checked ? 'on' : 'off'));
  return { field, show: ({ value }) => (field.checked = value === 'on') };
}

function choice({ option, choices }, { write }) {
  const field = document.createElement('select');
  field.append(...Object.entries(choices).map(([value, text]) => new Option(text, value)));
  field.addEventListener('input', () => write(option, field.value));
  return { field, show: ({ value }) => (field.value = value) };
}

function slider({ option, least, greatest, step, shown }, { read, write, columns }) {
  const field = document.createElement('span');
  field.className = 'slider';
  const range = document.createElement('input');
  const output = document.createElement('output');
  output.className = 'figures';
  Object.assign(range, { type: 'range', min: least, step });
  const tell = () => (output.textContent = shown(Number(range.value), Number(range.max)));
  range.addEventListener('input', () => {
    write(option, range.value);
    tell();
  });
  field.append(range, output);
  const show = ({ value }) => {
    range.max = kColumns.includes(option) ? greatest(columns()) : greatest;
    range.value = Number.isFinite(Number(value)) ? read(option, value) : read(option, null);
    tell();
  };
  return { field, show };
}
