// The script of the one HTML file: a <ray-caster> in the whole window, with the world of the page.
// Takes the page's parts (boot.js); requests nothing.

import '../../ray-caster.js';

const kShown = 6000; // milliseconds
const find = (id) => document.getElementById(id);
const decoder = new TextDecoder();

const bytes = await globalThis.slicecastPart('world');
const end = bytes.indexOf(0);
const { title, text, pictures } = JSON.parse(decoder.decode(bytes.subarray(0, end)));
const files = new Map();
let at = end + 1;
for (const [file, length] of pictures) {
  files.set(file, bytes.subarray(at, at + length));
  at += length;
}

const caster = document.createElement('ray-caster');
caster.loading = 'eager';
caster.controls = 'play reset sound save fullscreen';
caster.sound = true;
caster.label = title;
caster.source = { name: title, readText: () => text, readFile: (file) => files.get(file) ?? null };
caster.addEventListener('statechange', ({ detail: { state } }) => {
  document.body.dataset.state = state;
});
// Keys play at once.
caster.addEventListener('ready', () => requestAnimationFrame(() => caster.focus()), { once: true });
let timer = 0;
const tell = (words) => {
  find('told').textContent = words;
  clearTimeout(timer);
  timer = setTimeout(() => (find('told').textContent = ''), kShown);
};
caster.addEventListener('message', ({ detail }) => tell(detail.text));
caster.addEventListener('goal', ({ detail }) => tell(`Done in ${detail.seconds.toFixed(1)} s`));
find('told').textContent = '';
find('place').append(caster);

find('open-about').addEventListener('click', async () => {
  find('licences').textContent ||= decoder.decode(await globalThis.slicecastPart('texts'));
  find('about').showModal();
});
