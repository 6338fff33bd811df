// Loads the scene of the address anew whenever tools/play says that it was saved. Who plays stays
// where they are; what is wrong is shown until the file is saved without it.

export function listenForSaves(caster, address, face) {
  const saves = new EventSource(new URL('-/events', document.baseURI));
  let playsOn = false;
  saves.addEventListener('scene', async () => {
    if (address.reference === null) return;
    playsOn ||= caster.entered;
    face.isQuiet = true;
    caster.reload({ keepEye: true });
    await caster.whenReady().catch(() => {});
    if (caster.state === 'error' || !playsOn) return;
    playsOn = false;
    if (!caster.entered) caster.enter();
  });
}
