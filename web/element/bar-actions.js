// What the buttons of the bar do. A page can do all of it too.
//
//     const controls = new Controls(bar, barActions(element, show));

import { kOverlays } from '../engine/address.js';
import { isReachable } from '../engine/home.js';
import { node } from './nodes.js';
import { saveFile } from './save-file.js';
import { sharedParameters } from './share-links.js';

const kUsualOverlay = ['minimap'];

export function barActions(host, show) {
  return {
    play: () => (host.paused ? show.hold() : host.pause()),
    reset: () => host.reset(),
    overlay: () => toggleOverlays(host, show),
    sound: () => {
      show.muted = !show.muted;
    },
    save: () => save(host, show),
    share: () => share(host, show),
    fullscreen: () => toggleFullScreen(host, show),
  };
}

export function toggleFullScreen(host, show) {
  if (host.matches(':fullscreen')) host.ownerDocument.exitFullscreen();
  else
    host.requestFullscreen?.().catch(() => show.showStatus('This page does not allow full screen'));
}

// Switches on the overlays of the attribute, or the minimap.
function toggleOverlays(host, show) {
  const isAny = kOverlays.some((name) => host.get(name) === 'on');
  const names = isAny ? kOverlays : show.overlays.length > 0 ? show.overlays : kUsualOverlay;
  for (const name of names) host.set(name, !isAny);
  show.showState();
}

async function save(host, show) {
  const name =
    host.world.title
      .toLowerCase()
      .replace(/[^\p{L}\p{N}]+/gu, '-')
      .replace(/^-|-$/g, '') || 'picture';
  try {
    saveFile(`${name}.png`, await host.snapshot());
    show.showStatus(`Saved as ${name}.png`);
  } catch (error) {
    show.showStatus(error.message);
  }
}

// The element as the page wrote it, with the view and the options of now, and the script where it
// is a file of its own.
async function share(host, show) {
  const tag = host.cloneNode(true);
  // A second element with the id would clash, and a tour would override the view.
  for (const name of ['id', 'tour']) tag.removeAttribute(name);
  const { view, options, overlay } = sharedParameters({
    reference: '',
    view: { ...host.currentView, flying: host.flying },
    options: host.optionList,
  });
  for (const [name, value] of Object.entries({ view, options, overlay })) {
    if (value === null) tag.removeAttribute(name);
    else tag.setAttribute(name, value);
  }
  if (show.source.address !== null) tag.setAttribute('scene', show.source.address.href);
  if (typeof host.scene === 'object') {
    const json = node('script', { type: 'application/json' });
    json.textContent = JSON.stringify(host.scene).replaceAll('</', '<\\/');
    tag.append(json);
  }
  if (host.poster !== '')
    tag.setAttribute('poster', new URL(host.poster, host.ownerDocument.baseURI).href);
  const address = ownScript();
  const script = address === null ? '' : `<script type="module" src="${address}"></` + 'script>\n';
  try {
    await navigator.clipboard.writeText(`${script}${tag.outerHTML}`);
    show.showStatus('Copied: the tag with this view');
  } catch {
    show.showStatus('This browser did not allow copying');
  }
}

// The address of the element's script; null if it is bundled into another script, or if its address
// is that on the build machine.
function ownScript() {
  const here = import.meta.url;
  if (!/\/ray-caster-steering\.js(\?|$)/.test(here)) return null;
  const address = new URL('ray-caster.js', here);
  return isReachable(address) ? address.href : null;
}
