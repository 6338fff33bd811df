// Ctrl walks slowly and W walks ahead, but Ctrl+W closes the tab: so while Ctrl is held during
// play, the browser asks before it leaves. Ctrl+R is not asked about.

export function guardLeaving(caster) {
  let asks = false;
  for (const type of ['keydown', 'keyup']) {
    const listen = (event) => {
      asks = event.ctrlKey && event.code !== 'KeyR' && caster.entered;
    };
    caster.addEventListener(type, listen, { capture: true });
  }
  caster.addEventListener('enterchange', () => {
    asks &&= caster.entered;
  });
  window.addEventListener('beforeunload', (event) => {
    if (asks) event.preventDefault();
  });
}
