// Rows of the Lab: a label and a control for one option of the engine.
//
//     const row = optionRow(spec, { read, write, columns });
//     row.element, row.show(options)          shows the engine's values; options: name -> option
//
// read(name, value) returns the slider's number, write(name, text) sets the option, columns() is
// the picture's width.

const kColumns = ['inspectorColumn', 'drawnColumns']; // their range ends at the picture's width

// `spec` is {option, label}, with `choices` for a list, or with {least, greatest, step,
// shown(value)} for a slider; otherwise the control is a switch.
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
