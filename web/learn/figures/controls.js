// The controls of figures. Each is data: `markup(now, name)` writes it, `show(node, now)` brings a
// live one up to date, and `read(node, now)` tells the change that its input wishes.

import { crossing } from './geometry.js';
import { degrees, escape, fixed } from './markup.js';
import { changeOf, valueOf } from './now.js';

// eye: a field of the eye; option: of the engine; field: of the state.
export function slider({
  label,
  eye,
  option,
  field,
  from,
  to,
  step = 1,
  unit = '',
  opening,
  says,
  when,
}) {
  const itsField = field ?? (eye === undefined ? option : `eye.${eye}`);
  const range = (now) => [
    from ?? 0,
    to ?? { column: now.width - 1, row: now.height - 1, columns: now.width }[itsField] ?? 1,
  ];
  const valueIn = (now) => {
    const value = valueOf(now.state, itsField);
    if (eye !== 'heading') return value;
    return ((((value - from) % 360) + 360) % 360) + from;
  };
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const write = (now) => {
    const value = valueIn(now);
    if (says) return says(value, now);
    if (unit === '°') return degrees(value, digits);
    return `${fixed(value, digits)}${unit && ` ${unit}`}`;
  };
  const attributes = (now) => {
    const [least, greatest] = range(now);
    return {
      min: least,
      max: greatest,
      step,
      value: valueIn(now),
      'aria-valuetext': plain(write(now)),
    };
  };
  return {
    kind: 'slider',
    option,
    field: itsField,
    opening: opening ?? (eye || field === 'column' ? undefined : (from ?? 0)),
    when,
    markup: (now, name) =>
      `<label class="fig-control fig-slider"><span>${escape(label ?? itsField)}</span><output>${write(now)}</output>${input('range', name, attributes(now))}</label>`,
    show(node, now) {
      setAttributes(node.querySelector('input'), attributes(now));
      node.querySelector('output').textContent = plain(write(now));
    },
    read: (input) => changeOf(itsField, Number(input.value)),
  };
}

export function toggle({ label, option, field = option, opening, when }) {
  const isOption = option !== undefined;
  const isOn = (now) =>
    isOption ? [true, 'on'].includes(now.state[field]) : now.state[field] === true;
  return {
    kind: 'toggle',
    option,
    field,
    opening: isOption
      ? opening === false || opening === 'off'
        ? 'off'
        : 'on'
      : (opening ?? false),
    when,
    markup: (now, name) =>
      `<label class="fig-control fig-toggle">${input('checkbox', name, isOn(now) ? { checked: '' } : {})}<span>${escape(label)}</span></label>`,
    show(node, now) {
      node.querySelector('input').checked = isOn(now);
    },
    read: (input) => ({ [field]: isOption ? (input.checked ? 'on' : 'off') : input.checked }),
  };
}

// `of` maps values to their labels, or lists values; `oldWays` lists names of old ways.
export function choice({ label, option, field = option, of, oldWays, opening, when }) {
  const isList = Array.isArray(of);
  const values = oldWays ?? (isList ? of : Object.keys(of));
  const entries = values.map((value) => [value, String(isList || oldWays ? value : of[value])]);
  return {
    kind: 'choice',
    option,
    field,
    opening: opening ?? values[0],
    when,
    markup: (now, name) =>
      `<fieldset class="fig-control fig-choice"><legend>${escape(label)}</legend>${entries
        .map(
          ([value, text]) =>
            `<label>${input('radio', name, { value, ...(now.state[field] === value ? { checked: '' } : {}) })}<span>${escape(text)}</span></label>`,
        )
        .join('')}</fieldset>`,
    show(node, now) {
      node.querySelectorAll('input').forEach((input, index) => {
        input.checked = now.state[field] === values[index];
      });
    },
    read: (input, now, index) => ({ [field]: values[index] }),
  };
}

export function button({ label, change, when }) {
  return {
    kind: 'button',
    when,
    markup: () =>
      `<div class="fig-control fig-actions"><button type="button">${escape(label)}</button></div>`,
    show() {},
    press: (_, now) => change(now),
  };
}

// Goes through the steps of the slice, or through the columns of the frame, forwards and back.
export function scrub({ of = 'both', label, when } = {}) {
  const isFrame = of === 'frame';
  const most = (now) => (isFrame ? now.width : now.steps.length);
  const value = (now) =>
    Math.min((isFrame ? now.state.columns : now.state.step) ?? most(now), most(now));
  const changeTo = (next, now) => {
    const to = Math.max(0, Math.min(most(now), next));
    const kept = to >= most(now) ? null : to;
    return isFrame ? { columns: kept, column: Math.max(0, to - 1) } : { step: kept };
  };
  const says = (now) => {
    if (isFrame) return `${value(now)} of ${most(now)} slices`;
    return now.step === null ? `all ${most(now)} steps` : stepSays(now);
  };
  const attributes = (now) => ({
    min: 0,
    max: most(now),
    step: 1,
    value: value(now),
    'aria-valuetext': says(now),
  });
  const title =
    label ?? (isFrame ? 'Draw the picture' : of === 'runs' ? 'Fill the rows' : 'Follow the ray');
  return {
    kind: 'scrub',
    of,
    when,
    markup: (now, name) =>
      `<div class="fig-control fig-scrub"><span class="fig-scrub-name">${title}</span><output>${escape(says(now))}</output><button type="button" data-by="-1" aria-label="${title}: one step back">${kBack}</button>${input('range', name, { ...attributes(now), 'aria-label': title })}<button type="button" data-by="1" aria-label="${title}: one step on">${kOn}</button></div>`,
    show(node, now) {
      setAttributes(node.querySelector('input'), attributes(now));
      node.querySelector('output').textContent = says(now);
    },
    read: (input, now) => changeTo(Number(input.value), now),
    press: (node, now) => changeTo(value(now) + Number(node.dataset.by), now),
  };
}

const kBack =
  '<svg viewBox="0 0 24 24" width="24" height="24" aria-hidden="true"><path d="M15 5L8 12L15 19"/></svg>';
const kOn =
  '<svg viewBox="0 0 24 24" width="24" height="24" aria-hidden="true"><path d="M9 5L16 12L9 19"/></svg>';

// The current step in words.
export function stepSays(now) {
  const { step, slice, steps, state } = now;
  const place = `${state.step + 1} of ${steps.length}: `;
  if (step.of === 'run') {
    const run = slice.runs[step.index];
    const rows = run.first === run.last ? `row ${run.first}` : `rows ${run.first} to ${run.last}`;
    return `${place}${now.blockName(slice, run)}, ${rows}`;
  }
  const { tile } = slice.walk[step.index];
  if (step.kind === 'start') return `${place}the eye’s tile ${tile.join(', ')}`;
  const { axis, border, depth } = crossing(slice, step.index, now.eyes);
  return `${place}${axis} = ${border} at depth ${fixed(depth)}`;
}

function input(type, name, attributes) {
  const written = Object.entries({ type, name, ...attributes })
    .map(([key, value]) => ` ${key}="${escape(value)}"`)
    .join('');
  return `<input${written}/>`;
}

function setAttributes(input, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    // The value last: the browser keeps it within the range.
    if (name === 'value') continue;
    if (input.getAttribute(name) !== String(value)) input.setAttribute(name, value);
  }
  if (Number(input.value) !== attributes.value) input.value = String(attributes.value);
}

const plain = (markup) => String(markup).replace(/<[^>]*>/g, '');
