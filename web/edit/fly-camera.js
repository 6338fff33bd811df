// Flies the eye of a <ray-caster> while a world is built: keys move it, a drag turns it. The world
// stands still meanwhile. Takes keys and drags; gives views to the element. Knows no document.
//
//     const camera = new FlyCamera(caster);
//     camera.press('KeyW');  camera.release('KeyW');   // true if it is one of its keys
//     camera.turn(right, down);                        // CSS pixels
//     camera.move({ forward, right, up });             // units, at once: wheel and pinch
//     camera.stop();

const kKeys = {
  KeyW: ['forward', 1],
  ArrowUp: ['forward', 1],
  KeyS: ['forward', -1],
  ArrowDown: ['forward', -1],
  KeyD: ['right', 1],
  KeyA: ['right', -1],
  ArrowRight: ['turn', 1],
  ArrowLeft: ['turn', -1],
  Space: ['up', 1],
  KeyE: ['up', 1],
  KeyC: ['up', -1],
  KeyQ: ['up', -1],
};
const kSpeed = 5; // units per second
const kFast = 4; // times that with Shift
const kTurn = 100; // degrees per second
const kDegreesPerPixel = 0.2;
const kMostLook = 1.5; // screen heights
const kLowest = 0.05; // units above the floor
const kRadians = Math.PI / 180;

export class FlyCamera {
  #caster;
  #held = new Set();
  #frame = 0;
  #last = 0;
  isFast = false;

  constructor(caster) {
    this.#caster = caster;
  }

  press(code) {
    if (!Object.hasOwn(kKeys, code)) return false;
    this.#held.add(code);
    if (this.#frame === 0) {
      this.#last = performance.now();
      this.#frame = requestAnimationFrame((now) => this.#fly(now));
    }
    return true;
  }

  release(code) {
    this.#held.delete(code);
  }

  stop() {
    this.#held.clear();
  }

  // Whether keys move the eye at present.
  get isHeld() {
    return this.#held.size > 0;
  }

  turn(right, down) {
    const view = this.#caster.currentView;
    if (view === null) return;
    const perHeight = this.#caster.clientHeight;
    this.#look({
      ...view,
      heading: view.heading + right * kDegreesPerPixel,
      look: clamp(view.look - down / perHeight, -kMostLook, kMostLook),
    });
  }

  move({ forward = 0, right = 0, up = 0 }) {
    const view = this.#caster.currentView;
    if (view === null) return;
    const angle = view.heading * kRadians;
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    this.#look({
      ...view,
      x: view.x + forward * cos - right * sin,
      y: view.y + forward * sin + right * cos,
      z: Math.max(kLowest, view.z + up),
    });
  }

  #look(view) {
    const heading = ((view.heading % 360) + 360) % 360;
    this.#caster.look({ ...view, heading, flying: true });
  }

  #fly(now) {
    const seconds = Math.min(0.1, (now - this.#last) / 1000);
    this.#last = now;
    const sum = { forward: 0, right: 0, up: 0, turn: 0 };
    for (const code of this.#held) {
      const [axis, sign] = kKeys[code];
      sum[axis] += sign;
    }
    const far = seconds * kSpeed * (this.isFast ? kFast : 1);
    if (sum.turn !== 0) this.turn((sum.turn * seconds * kTurn) / kDegreesPerPixel, 0);
    if (sum.forward !== 0 || sum.right !== 0 || sum.up !== 0)
      this.move({ forward: sum.forward * far, right: sum.right * far, up: sum.up * far });
    this.#frame = this.#held.size > 0 ? requestAnimationFrame((time) => this.#fly(time)) : 0;
  }
}

function clamp(value, least, most) {
  return Math.min(most, Math.max(least, value));
}
