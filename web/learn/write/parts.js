// Builds what the panel adds to the page: everything but the program, which is there already.
//
//     const parts = makeParts(element, { size, scene, view, options, time, acts })
//
// `acts` are what the controls do; `time` is where the seconds of the world begin, or null.

import { button, make } from './make.js';

const kMostSeconds = 12;
const kLabel = 'Your program. Tab leaves the editor.';
const kPictureLabel =
  'Your picture. Left and right turn, up and down walk, Shift with left and right steps aside.';

export function makeParts(element, { size, scene, view, options, time, acts }) {
  const pre = element.querySelector('.write-program');
  const code = pre.querySelector('code');
  const host = pre.parentElement;
  pre.setAttribute('aria-label', kLabel);
  pre.addEventListener('focus', () => acts.edit());
  pre.addEventListener('click', (event) => acts.edit(event));

  const box = (name, attributes = {}) => make('div', { class: name, ...attributes });
  const note = box('write-note', { hidden: true });
  const run = button('Run', acts.run, { class: 'write-run', title: 'Control and Enter' });
  const status = make('p', { class: 'write-status', role: 'status' });
  const errorBox = box('write-error', { hidden: true });
  const answer = box('write-answer', { hidden: true });
  const earlier = box('write-earlier', { hidden: true });
  const share = box('write-sharebox', { hidden: true });
  const bar = box('write-bar');
  bar.append(run, status);
  const tools = box('write-tools');
  tools.append(
    button('Start from our state', acts.start),
    button('Show the answer', acts.answer),
    button('Earlier versions', acts.earlier),
    button('Share', acts.share),
    button('Download', acts.download),
  );
  const keys = make(
    'p',
    { class: 'write-keys' },
    'Tab leaves the editor. Ctrl ] indents, Ctrl Enter runs.',
  );
  host.before(note);
  host.after(keys, bar, errorBox, tools, share, earlier, answer);

  const canvas = (label) => make('canvas', { ...size, role: 'img', 'aria-label': label });
  const mine = canvas('Your picture');
  const difference = canvas('Where the pictures differ');
  const caster = make('ray-caster', {
    scene,
    view,
    options,
    size: `${size.width}x${size.height}`,
    interaction: 'none',
    loading: 'eager',
    label: 'The engine’s picture',
  });
  const mineFigure = figure('Yours', mine);
  const stick = mineFigure.querySelector('.write-frame');
  stick.tabIndex = 0;
  stick.setAttribute('role', 'application');
  stick.setAttribute('aria-label', kPictureLabel);
  const steps = [
    ['←', 'Turn left'],
    ['↑', 'Walk ahead'],
    ['↓', 'Walk back'],
    ['→', 'Turn right'],
  ].map(([sign, label]) => button(sign, () => {}, { 'aria-label': label, title: label }));
  const home = button('To the start', acts.home, { hidden: true });
  const steering = box('write-steering', { role: 'group', 'aria-label': 'The eye' });
  steering.append(...steps, home);
  if (time !== null) steering.append(timeSlider(time, acts.time));
  const pictures = box('write-pictures');
  pictures.append(
    mineFigure,
    steering,
    figure('The engine’s', caster),
    figure('Difference', difference, ' – bright: differs; blank: not taught yet'),
  );

  const functions = make('div');
  const pixelBox = make('div');
  const firstBox = make('div');
  const results = box('write-results');
  results.append(
    make('div', {}, make('h3', {}, 'Functions'), functions),
    make('div', {}, make('h3', {}, 'Pixels'), pixelBox, firstBox),
  );
  element.querySelector('.write-bench').append(pictures, results);
  element.classList.add('alive');

  return {
    ...{ pre, code, host, note, run, status, errorBox, answer, earlier, share },
    ...{ mine, mineFigure, stick, steps, home, caster, difference },
    ...{ functions, pixelBox, firstBox },
  };
}

function timeSlider(time, act) {
  const output = make('output', {}, `${time} s`);
  const range = make('input', {
    ...{ id: 'write-time', type: 'range', min: 0, max: kMostSeconds, step: 0.25, value: time },
    oninput: () => {
      output.textContent = `${range.value} s`;
      act(Number(range.value));
    },
  });
  const label = make('label', { for: 'write-time' }, 'Time');
  return make('div', { class: 'write-time' }, label, ' ', output, range);
}

function figure(title, picture, note = '') {
  return make(
    'figure',
    { class: 'write-picture' },
    make('figcaption', {}, make('b', {}, title), note),
    make(
      'div',
      { class: 'write-frame' },
      picture,
      make('div', { class: 'write-column', hidden: true }),
    ),
  );
}
