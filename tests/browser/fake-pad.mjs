// A fake gamepad, provided through the browser's own interface.

// window.pad(axes, pressed buttons) sets it; the first call connects it, window.unplug() takes it
// away.
export async function withPad(page) {
  await page.addInitScript(() => {
    let pad = null;
    navigator.getGamepads = () => [null, pad];
    window.pad = (axes = [0, 0, 0, 0], pressed = [], mapping = 'standard') => {
      const isNew = pad === null;
      const buttons = Array.from({ length: 17 }, (_, index) => ({
        pressed: pressed.includes(index),
        value: pressed.includes(index) ? 1 : 0,
      }));
      pad = { connected: true, mapping, axes, buttons, index: 1, id: 'fake', timestamp: 0 };
      if (isNew) window.dispatchEvent(new Event('gamepadconnected'));
    };
    window.unplug = () => {
      pad = null;
    };
  });
}
