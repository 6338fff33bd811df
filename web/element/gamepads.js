// Reads gamepads for the engine. A browser reports a gamepad once a button was pressed; its state
// must be polled, here once per frame while one is connected.
//
//     const gamepads = new Gamepads({change(pad), press()});
//     gamepads.stop();
//
// `pad` is {leftX, leftY, rightX, rightY, leftTrigger, rightTrigger, buttons}, as slicecast_gamepad
// takes it. press() is called when a button goes down, and may be missing.

const kNone = {
  leftX: 0,
  leftY: 0,
  rightX: 0,
  rightY: 0,
  leftTrigger: 0,
  rightTrigger: 0,
  buttons: 0,
};
const kTriggers = 6; // buttons 6 and 7 are the triggers, which are axes here

export class Gamepads {
  #before = kNone;
  #asks = false;
  #ended = new AbortController();

  constructor(actions) {
    this.actions = actions;
    window.addEventListener('gamepadconnected', () => this.#begin(), {
      signal: this.#ended.signal,
    });
    if (connected().length > 0) this.#begin();
  }

  // Stops polling and releases what was held.
  stop() {
    this.#ended.abort();
    if (this.#before !== kNone) this.actions.change(kNone);
  }

  #begin() {
    if (this.#asks) return;
    this.#asks = true;
    const look = () => {
      if (this.#ended.signal.aborted) return;
      const pads = connected();
      const now = pads.length > 0 ? stateOf(pads) : kNone;
      if (Object.keys(kNone).some((key) => now[key] !== this.#before[key])) {
        const isPress = (now.buttons & ~this.#before.buttons) !== 0;
        this.#before = now;
        this.actions.change(now);
        if (isPress) this.actions.press?.();
      }
      this.#asks = pads.length > 0;
      if (this.#asks) requestAnimationFrame(look);
    };
    look();
  }
}

function connected() {
  return [...(navigator.getGamepads?.() ?? [])].filter(
    (pad) => pad !== null && pad.connected && pad.mapping === 'standard',
  );
}

// Merges several gamepads into one: each axis is the one furthest out, and a button is down if it
// is down on any.
export function stateOf(pads) {
  const furthest = (values) =>
    values.reduce((most, value) => (Math.abs(value) > Math.abs(most) ? value : most), 0);
  const axis = (index) => furthest(pads.map((pad) => pad.axes[index] ?? 0));
  const trigger = (index) => furthest(pads.map((pad) => pad.buttons[index]?.value ?? 0));
  let buttons = 0;
  for (const pad of pads) {
    pad.buttons.forEach(({ pressed }, index) => {
      if (pressed && index !== kTriggers && index !== kTriggers + 1) buttons |= 1 << index;
    });
  }
  return {
    leftX: axis(0),
    leftY: axis(1),
    rightX: axis(2),
    rightY: axis(3),
    leftTrigger: trigger(kTriggers),
    rightTrigger: trigger(kTriggers + 1),
    buttons,
  };
}
