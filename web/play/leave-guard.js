// Ctrl walks slowly, and Ctrl with W closes the tab: while Ctrl is held on the canvas the browser
// asks first. Ctrl and R is meant.

export function guardLeaving(canvas) {
  let asks = false;
  for (const type of ['keydown', 'keyup']) {
    canvas.addEventListener(type, (event) => {
      asks = event.ctrlKey && event.code !== 'KeyR';
    });
  }
  canvas.addEventListener('blur', () => {
    asks = false;
  });
  window.addEventListener('beforeunload', (event) => {
    if (asks) event.preventDefault();
  });
}
