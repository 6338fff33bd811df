// What the page around a frame can ask of the <ray-caster> in it, and hears from it, by postMessage:
//
//     {slicecast: 1, id: 7, call: 'look', arguments: ['4,5,0.6,90']}        a method, with its arguments
//     {slicecast: 1, id: 8, get: 'currentView'}                             an attribute or a property
//     {slicecast: 1, id: 9, set: 'options', value: 'fov=75'}                an attribute
//
//     {slicecast: 1, id: 7, result}   or   {slicecast: 1, id: 7, error: {code, message}}
//     {slicecast: 1, event: 'viewchange', detail}                           each event of the element
//
//     listenToHost(caster, 'https://host.example', {scene: (text) => address});      // `others` read what is set where not every value may be
//
// Only the page right around the frame is heard, and only if it is of that origin; nobody else is
// told anything.

const kMethods = [
  'play',
  'pause',
  'reset',
  'step',
  'set',
  'get',
  'look',
  'snapshot',
  'hits',
  'trace',
  'whenReady',
];
const kProperties = [
  'state',
  'paused',
  'world',
  'memory',
  'currentView',
  'picture',
  'error',
  'warnings',
  'optionList',
];
const kAttributes = [
  'scene',
  'tour',
  'view',
  'size',
  'controls',
  'options',
  'overlay',
  'label',
  'keys',
  'interaction',
];
const kEvents = ['ready', 'progress', 'error', 'warning', 'viewchange', 'portal', 'statechange'];

export function listenToHost(caster, origin, others) {
  if (window.parent === window || !isOrigin(origin)) return;
  const tell = (message) => window.parent.postMessage({ slicecast: 1, ...message }, origin);
  window.addEventListener('message', async ({ source, origin: from, data }) => {
    if (source !== window.parent || from !== origin || data?.slicecast !== 1) return;
    const { id = null } = data;
    try {
      tell({ id, result: await answer(caster, data, others) });
    } catch (error) {
      tell({ id, error: { code: error.code ?? 'message', message: error.message } });
    }
  });
  for (const event of kEvents)
    caster.addEventListener(event, ({ detail }) => tell({ event, detail }));
}

// As https://host.example: whoever is told must be known.
function isOrigin(text) {
  try {
    return new URL(text).origin === text;
  } catch {
    return false;
  }
}

function answer(caster, { call, get, set, value, arguments: given = [] }, others) {
  if (kMethods.includes(call)) return caster[call](...given);
  if ([...kProperties, ...kAttributes].includes(get)) return caster[get];
  if (!kAttributes.includes(set))
    throw new Error(
      `Expected call with one of ${kMethods.join(', ')}; get with one of ${kProperties.join(', ')}; or set with one of ${kAttributes.join(', ')}.`,
    );
  if (value !== null && !['string', 'boolean'].includes(typeof value))
    throw new Error(`Expected a text, true, false or null for ${set}.`);
  caster[set] = typeof value === 'string' && set in others ? others[set](value) : value;
  return null;
}
