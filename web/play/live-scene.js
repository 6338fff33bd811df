// Reloads the scene of the address whenever tools/play reports that it was saved. The player stays
// where they are; faults are shown until the file is saved without them.

export function listenForSaves(caster, address, status) {
  const saves = new EventSource(new URL('-/events', document.baseURI));
  let playsOn = false; // somebody steered before the faults
  saves.addEventListener('scene', async () => {
    if (address.reference === null) return;
    playsOn ||= caster.entered;
    status.isQuiet = true;
    caster.reload({ keepEye: true });
    await caster.whenReady().catch(() => {});
    if (caster.state === 'error' || !playsOn) return;
    playsOn = false;
    if (!caster.entered) caster.enter();
  });
}
