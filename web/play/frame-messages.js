// Lets the page around a frame control the <ray-caster> in it by postMessage:
//
//     {slicecast: 1, id: 7, call: 'look', arguments: ['4,5,0.6,90']}     a method and its arguments
//     {slicecast: 1, id: 8, get: 'currentView'}                           an attribute or property
//     {slicecast: 1, id: 9, set: 'options', value: 'fov=75'}              an attribute
//
// The frame answers
//
//     {slicecast: 1, id: 7, result}   or   {slicecast: 1, id: 7, error: {code, message}}
//     {slicecast: 1, event: 'viewchange', detail}                         for each event
//
//     listenToHost(caster, 'https://host.example', {scene: (text) => address});
//
// The last argument has functions that check or convert texts for the attributes that it names.
// Messages are accepted from, and sent to, only the frame's direct parent, if it has that origin.

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

export function listenToHost(caster, origin, converters) {
  if (window.parent === window || !isOrigin(origin)) return;
  const tell = (message) => window.parent.postMessage({ slicecast: 1, ...message }, origin);
  window.addEventListener('message', async ({ source, origin: from, data }) => {
    if (source !== window.parent || from !== origin || data?.slicecast !== 1) return;
    const { id = null } = data;
    try {
      tell({ id, result: await answer(caster, data, converters) });
    } catch (error) {
      tell({ id, error: { code: error.code ?? 'message', message: error.message } });
    }
  });
  for (const event of kEvents)
    caster.addEventListener(event, ({ detail }) => tell({ event, detail }));
}

// Whether the text is a full origin such as https://host.example; "*" is refused.
function isOrigin(text) {
  try {
    return new URL(text).origin === text;
  } catch {
    return false;
  }
}

function answer(caster, { call, get, set, value, arguments: inputs = [] }, converters) {
  if (kMethods.includes(call)) return caster[call](...inputs);
  if ([...kProperties, ...kAttributes].includes(get)) return caster[get];
  if (!kAttributes.includes(set))
    throw new Error(
      `Expected call with one of ${kMethods.join(', ')}; get with one of ${kProperties.join(', ')}; or set with one of ${kAttributes.join(', ')}.`,
    );
  if (value !== null && !['string', 'boolean'].includes(typeof value))
    throw new Error(`Expected a text, true, false or null for ${set}.`);
  caster[set] =
    typeof value === 'string' && Object.hasOwn(converters, set) ? converters[set](value) : value;
  return null;
}
