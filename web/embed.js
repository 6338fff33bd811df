// A page that is nothing but one <ray-caster>, for frames:
// embed.html?scene=castle&view=...&options=...
//
// Parameters: scene (a name among the page's scenes, or an address), or tour (the same for a
// recording, which names its scene); view, options, overlay, size, controls, label, keys and engine
// as the element's attributes of these names; autoplay (without a value). What the element finds
// wrong it says itself; parameters that it does not know are left to whoever wrote them.

import { writeQuery } from './engine/address.js';
import { unknown } from './engine/nearest-name.js';
import { sceneAddress } from './play/scene-list.js';
import { Trouble, asTrouble } from './engine/trouble.js';
import './ray-caster.js';

const kParameters = [
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
  'engine',
];
const kOfPlayPage = ['scene', 'tour', 'view', 'options', 'overlay', 'engine'];
const kTourName = /^[\w-]+$/;

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
  for (const name of kParameters)
    if (parameters.has(name)) caster.setAttribute(name, parameters.get(name));
  if (!parameters.has('controls')) caster.setAttribute('controls', '');
  // Seen as soon as its frame is, and a frame that waits for that says so to the page around it.
  caster.setAttribute('loading', 'eager');
  if (parameters.has('scene'))
    caster.setAttribute('scene', sceneAddress(parameters.get('scene')).href);
  if (kTourName.test(parameters.get('tour') ?? ''))
    caster.setAttribute(
      'tour',
      new URL(`tours/${parameters.get('tour')}.txt`, document.baseURI).href,
    );
  caster.addEventListener('ready', ({ detail }) => {
    document.title = `${detail.title} · Slicecast`;
    find('title').textContent = detail.title;
  });
  caster.addEventListener('statechange', ({ detail }) => {
    document.body.dataset.state = detail.state;
  });
  find('place').append(caster);
  offerPlayPage(parameters);
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
