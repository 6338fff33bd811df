// A page that is nothing but one <ray-caster>, for frames:
// embed.html?scene=castle&view=...&options=...
//
// Parameters: scene (a name among the page's scenes, or an address as far as its owner allows it:
// engine/allowed.js), or tour (the same for a recording, which names its scene); poster, as far as
// its owner allows it; view, options, overlay, size, controls, label, keys, interaction, loading and
// engine as the element's attributes of these names; autoplay (without a value); badge=false for no
// link to the play page; origin, of the page around the frame, with which it then exchanges messages
// (play/frame-messages.js). What the element finds wrong it says itself; parameters that it does not
// know are left to whoever wrote them.

import { writeQuery } from './engine/address.js';
import { allowed } from './engine/allowed.js';
import { unknown } from './engine/nearest-name.js';
import { listenToHost } from './play/frame-messages.js';
import { sceneAddress } from './play/scene-list.js';
import { hostOf, nameFrom, titleFrom } from './play/whose.js';
import { Trouble, asTrouble } from './engine/trouble.js';
import './ray-caster.js';

const kAttributes = [
  'scene',
  'tour',
  'view',
  'options',
  'overlay',
  'size',
  'autoplay',
  'controls',
  'label',
  'keys',
  'interaction',
  'poster',
  'loading',
  'engine',
];
const kParameters = [...kAttributes, 'badge', 'origin'];
const kNoBadge = ['false', 'off', 'no', 'none', '0'];
const kOfPlayPage = ['scene', 'tour', 'view', 'options', 'overlay', 'engine'];
const kTourName = /^[\w-]+$/;

// What may only name some addresses.
const kAddresses = {
  scene: (text) => sceneAddress(text).href,
  tour: (text) =>
    allowed(new URL(kTourName.test(text) ? `tours/${text}.txt` : text, document.baseURI)).href,
  poster: (text) => allowed(new URL(text, document.baseURI)).href,
};

const find = (id) => document.getElementById(id);

try {
  show(new URLSearchParams(location.search));
} catch (error) {
  const { title, message } = asTrouble(error);
  find('trouble-title').textContent = title;
  find('trouble-text').textContent = message;
  find('trouble').hidden = false;
}

function show(parameters) {
  check(parameters);
  const caster = document.createElement('ray-caster');
  for (const name of kAttributes)
    if (parameters.has(name)) caster.setAttribute(name, parameters.get(name));
  if (!parameters.has('controls') && parameters.get('interaction') !== 'none')
    caster.setAttribute('controls', '');
  // Seen as soon as its frame is, and a frame that waits for that says so to the page around it.
  if (parameters.get('loading') !== 'click') caster.setAttribute('loading', 'eager');
  for (const [name, read] of Object.entries(kAddresses))
    if (parameters.get(name)) caster.setAttribute(name, read(parameters.get(name)));
  const whose = find('whose');
  const sayWhose = (text) => {
    whose.textContent = text;
    whose.hidden = hostOf(caster.scene || caster.address) === '';
  };
  caster.addEventListener('ready', ({ detail }) => {
    const title = titleFrom(caster.address, detail.title);
    document.title = `${title} · Slicecast`;
    find('title').textContent = title;
    if (!parameters.get('label')) caster.label = nameFrom(caster.address, detail.title);
    sayWhose(title);
  });
  caster.addEventListener('statechange', ({ detail }) => {
    document.body.dataset.state = detail.state;
    if (detail.state === 'loading') sayWhose(`A scene from ${hostOf(caster.scene)}`);
  });
  sayWhose(`A scene from ${hostOf(caster.scene)}`);
  find('place').append(caster);
  listenToHost(caster, parameters.get('origin') || location.origin, kAddresses);
  if (!kNoBadge.includes(parameters.get('badge'))) offerPlayPage(parameters);
}

function check(parameters) {
  for (const name of new Set(parameters.keys())) {
    if (!kParameters.includes(name)) console.warn(unknown('parameter', name, kParameters));
    else if (parameters.getAll(name).length > 1)
      console.warn(`The parameter '${name}' stands there more than once; the first one counts.`);
  }
  if (!parameters.get('scene') && !parameters.get('tour')) {
    throw new Trouble(
      'The address names no scene',
      'Found neither scene nor tour, expected one of them, as in embed.html?scene=castle.',
    );
  }
}

// A sandboxed frame may open no other window, but may go there itself.
function offerPlayPage(parameters) {
  const kept = kOfPlayPage
    .filter((name) => parameters.has(name))
    .map((name) => [name, parameters.get(name)]);
  const link = find('open');
  link.href = `index.html${writeQuery(Object.fromEntries(kept))}`;
  link.target = self.origin === 'null' ? '_self' : '_blank';
  link.hidden = false;
}
