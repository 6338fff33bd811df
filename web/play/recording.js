// F9: begins the scene anew and records it, or hands out what was recorded.

import { saveFile } from '../element/save-file.js';

export async function toggleRecording(caster, address) {
  const name = (address.reference ?? caster.source.name).replace(/^.*\/|\.json$/gi, '');
  const text = caster.takeRecording();
  if (text !== '') {
    saveFile(`${name}-recording.txt`, new Blob([text], { type: 'text/plain' }));
    return;
  }
  if (caster.source === null) caster.scene = caster.address; // a tour may have named it
  caster.tour = null;
  caster.view = null;
  caster.reload();
  await caster.whenReady();
  caster.record(name);
  caster.enter();
}
