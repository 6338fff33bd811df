// Ctrl walks slowly, and Ctrl with W closes the tab: while Ctrl is held in the picture the browser
// asks first. Ctrl and R is meant.

export function guardLeaving(caster) {
  let asks = false;
  for (const type of ['keydown', 'keyup']) {
    caster.addEventListener(type, (event) => {
      asks = event.ctrlKey && event.code !== 'KeyR' && caster.entered;
    });
  }
  caster.addEventListener('enterchange', () => {
    asks &&= caster.entered;
  });
  window.addEventListener('beforeunload', (event) => {
    if (asks) event.preventDefault();
  });
}
