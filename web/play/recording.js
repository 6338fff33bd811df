// F9: restarts the scene and records it, or saves the recording and says so.

import { saveFile } from '../element/save-file.js';

export async function toggleRecording(caster, address, say) {
  const name = (address.reference ?? caster.source.name).replace(/^.*\/|\.json$/gi, '');
  const text = caster.takeRecording();
  if (text !== '') {
    const file = `${name}-recording.txt`;
    saveFile(file, new Blob([text], { type: 'text/plain' }));
    say(`Saved: ${file}`);
    return;
  }
  if (caster.source === null) caster.scene = caster.address; // it may come from a tour
  caster.tour = null;
  caster.view = null;
  caster.reload();
  await caster.whenReady();
  caster.record(name);
  caster.enter();
}
