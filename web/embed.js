// A page with a single <ray-caster>, for frames: embed.html?scene=castle&view=...&options=...
//
// Parameters:
//
//     scene          one of the page's scenes, or an address that its owner allows
//                    (engine/allowed.js)
//     tour           a recording, which names its scene: likewise
//     poster         an address that the owner allows
//     view, options, overlay, size, controls, label, keys, interaction, loading, engine, autoplay,
//     sound          the element's attributes
//     badge=false    no link to the play page
//     origin         the origin of the page around the frame, to exchange messages with it
//                    (play/frame-messages.js)
//
// The element reports bad values. Unknown parameters only cause a warning on the console.

import { writeQuery } from './engine/address.js';
import { allowed } from './engine/allowed.js';
import { unknown } from './engine/nearest-name.js';
import { listenToHost } from './play/frame-messages.js';
import { sceneAddress } from './play/scene-list.js';
import { hostOf, nameFrom, titleFrom } from './play/scene-origin.js';
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
  'sound',
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

// Parameters that may name only allowed addresses.
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
  // A frame shows nothing else, so it loads at once; loading="lazy" on the <iframe> can delay it.
  if (parameters.get('loading') !== 'click') caster.setAttribute('loading', 'eager');
  for (const [name, read] of Object.entries(kAddresses))
    if (parameters.get(name)) caster.setAttribute(name, read(parameters.get(name)));
  const origin = find('origin');
  const showOrigin = (address, text) => {
    origin.textContent = text;
    origin.hidden = hostOf(address) === '';
  };
  const showNext = () => showOrigin(caster.scene, `A scene from ${hostOf(caster.scene)}`);
  caster.addEventListener('ready', ({ detail }) => {
    const title = titleFrom(caster.address, detail.title);
    document.title = `${title} · Slicecast`;
    find('title').textContent = title;
    if (!parameters.get('label')) caster.label = nameFrom(caster.address, detail.title);
    showOrigin(caster.address, title);
  });
  caster.addEventListener('statechange', ({ detail }) => {
    document.body.dataset.state = detail.state;
    if (detail.state === 'loading') showNext();
  });
  showNext();
  find('place').append(caster);
  listenToHost(caster, parameters.get('origin') || location.origin, kAddresses);
  if (!kNoBadge.includes(parameters.get('badge'))) offerPlayPage(parameters);
}

function check(parameters) {
  for (const name of new Set(parameters.keys())) {
    if (!kParameters.includes(name)) console.warn(unknown('parameter', name, kParameters));
    else if (parameters.getAll(name).length > 1)
      console.warn(`The parameter '${name}' appears more than once; the first one counts.`);
  }
  if (!parameters.get('scene') && !parameters.get('tour')) {
    throw new Trouble(
      'The address names no scene',
      'Found neither scene nor tour. Expected one of them, as in embed.html?scene=castle.',
    );
  }
}

// A sandboxed frame may not open another window, so there the link opens in the frame itself.
function offerPlayPage(parameters) {
  const kept = kOfPlayPage
    .filter((name) => parameters.has(name))
    .map((name) => [name, parameters.get(name)]);
  const link = find('open');
  link.href = `index.html${writeQuery(Object.fromEntries(kept))}`;
  link.target = self.origin === 'null' ? '_self' : '_blank';
  link.hidden = false;
}
