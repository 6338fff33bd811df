// Recordings of the page: from the start of the scene that is open, as text files.

import { saveFile } from '../element/save-file.js';

// Restarts the scene and records it. The keys go to the picture, or with `touch` it shows thumbs;
// the mouse stays free.
export async function beginRecording(caster, address, touch) {
  if (caster.source === null) caster.scene = caster.address; // it may come from a tour
  caster.tour = null;
  caster.view = null;
  caster.reload();
  await caster.whenReady();
  caster.record(nameOf(caster, address));
  caster.enter({ touch });
}

// The file of a recording of this scene.
export function recordingFile(caster, address, text) {
  return new File([text], `${nameOf(caster, address)}-recording.txt`, { type: 'text/plain' });
}

export function saveRecording(file) {
  saveFile(file.name, file);
}

// How many steps a recording has.
export function stepsOf(text) {
  return Number(/^end (\d+)/m.exec(text)?.[1] ?? 0);
}

function nameOf(caster, address) {
  return (address.reference ?? caster.source.name).replace(/^.*\/|\.json$/gi, '');
}
