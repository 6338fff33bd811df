// Steering by thumbs, or a pen. In the left half of the picture a stick appears under the thumb and
// walks; far beyond its rim it runs. Dragging in the right half looks around; two taps there jump.
// Buttons jump, crouch and fly; while flying, the first two rise and sink. If the world has gates,
// another button opens and closes them.
//
//     const thumbs = new Thumbs(root, {hold(held), drag(right, down), fly()});
//     thumbs.flying = true;
//     thumbs.hasGates = false;
//
// `held` is {forward, strafe, fly, jump, fast, use}.

const kRadius = 56; // CSS pixels from the middle of the stick to its rim
const kDeadZone = 0.15; // of the radius: a thumb that rests in the middle does nothing
const kRunning = 1.5; // radii from the middle at which running starts
const kTapMilliseconds = 250; // a longer touch is not a tap
const kTapPixels = 12; // nor is one that moves further
const kBetweenTaps = 350; // milliseconds at most
const kEvents = ['start', 'move', 'end', 'cancel']
  .map((what) => `touch${what}`)
  .concat(['down', 'move', 'up', 'cancel'].map((what) => `pointer${what}`))
  .concat(['mousedown', 'mousemove', 'mouseup', 'click']);
const kJumpMilliseconds = 120; // how long a tap holds jump or use: long enough for a step to see it

// Turns the thumb's offset from the stick's middle into axes right and down, -1 to 1, and whether
// it runs.
export function stickAt(x, y) {
  const distance = Math.hypot(x, y) / kRadius;
  if (distance <= kDeadZone) return { right: 0, down: 0, runs: false };
  const scale = Math.min(1, (distance - kDeadZone) / (1 - kDeadZone)) / (distance * kRadius);
  return { right: x * scale, down: y * scale, runs: distance >= kRunning };
}

export class Thumbs {
  #held = { forward: 0, strafe: 0, jump: false, crouch: false, fast: false, use: false };
  #jumpTimer = 0;
  #useTimer = 0;
  #touches = []; // of followTouch()

  constructor(root, actions) {
    this.actions = actions;
    this.find = (name) => root.querySelector(`[data-thumb="${name}"]`);
    this.#listenToStick(this.find('walk'), this.find('stick'));
    this.#listenToLook(this.find('look'));
    for (const name of ['jump', 'crouch']) this.#listenToButton(this.find(name), name);
    this.find('use').addEventListener('pointerdown', (event) => {
      event.preventDefault();
      this.#hold({ use: true });
      clearTimeout(this.#useTimer);
      this.#useTimer = setTimeout(() => this.#hold({ use: false }), kJumpMilliseconds);
    });
    this.find('fly').addEventListener('pointerdown', (event) => {
      event.preventDefault();
      actions.fly();
    });
    // Prevents loss of focus, zooming and text selection.
    for (const type of ['mousedown', 'touchstart', 'contextmenu'])
      root.addEventListener(type, (event) => event.preventDefault(), { passive: false });
    // A page around it may turn its slides by swiping.
    for (const type of kEvents) root.addEventListener(type, (event) => event.stopPropagation());
  }

  set flying(flying) {
    this.find('fly').classList.toggle('on', flying);
    this.find('jump').querySelector('span').textContent = flying ? 'Rise' : 'Jump';
    this.find('crouch').querySelector('span').textContent = flying ? 'Sink' : 'Crouch';
    this.#send();
  }

  set hasGates(hasGates) {
    this.find('use').hidden = !hasGates;
  }

  // Releases everything, even under fingers that are still down: a removed element never gets their
  // pointerup.
  release() {
    for (const touch of this.#touches) touch.drop();
    clearTimeout(this.#jumpTimer);
    clearTimeout(this.#useTimer);
    this.#hold({ forward: 0, strafe: 0, jump: false, crouch: false, fast: false, use: false });
  }

  #hold(change) {
    Object.assign(this.#held, change);
    this.#send();
  }

  #send() {
    const { forward, strafe, jump, crouch, fast, use } = this.#held;
    this.actions.hold({
      forward,
      strafe,
      fast,
      use,
      jump,
      fly: crouch ? -1 : 0,
    });
  }

  #listenToStick(zone, stick) {
    const knob = stick.querySelector('.knob');
    let middle = null;
    this.#listen(zone, {
      begin: (event) => {
        middle = { x: event.clientX, y: event.clientY };
        const box = zone.getBoundingClientRect();
        stick.style.setProperty('--x', `${middle.x - box.left}px`);
        stick.style.setProperty('--y', `${middle.y - box.top}px`);
        stick.classList.add('held');
      },
      move: (event) => {
        const x = event.clientX - middle.x;
        const y = event.clientY - middle.y;
        const reach = Math.min(1, kRadius / Math.max(1, Math.hypot(x, y)));
        knob.style.transform = `translate(${x * reach}px, ${y * reach}px)`;
        const { right, down, runs } = stickAt(x, y);
        stick.classList.toggle('runs', runs);
        this.#hold({ forward: -down, strafe: right, fast: runs });
      },
      end: () => {
        stick.classList.remove('held', 'runs');
        for (const name of ['--x', '--y']) stick.style.removeProperty(name);
        knob.style.transform = '';
        this.#hold({ forward: 0, strafe: 0, fast: false });
      },
    });
  }

  #listenToLook(zone) {
    let at = null;
    let moved = 0;
    let begun = 0;
    let lastTap = -Infinity;
    this.#listen(zone, {
      begin: (event) => {
        at = { x: event.clientX, y: event.clientY };
        moved = 0;
        begun = event.timeStamp;
      },
      move: (event) => {
        const right = event.clientX - at.x;
        const down = event.clientY - at.y;
        at = { x: event.clientX, y: event.clientY };
        moved += Math.hypot(right, down);
        this.actions.drag(right, down);
      },
      end: (event) => {
        if (
          event?.type !== 'pointerup' ||
          moved > kTapPixels ||
          event.timeStamp - begun > kTapMilliseconds
        )
          return;
        if (event.timeStamp - lastTap < kBetweenTaps) {
          lastTap = -Infinity;
          this.#hold({ jump: true });
          clearTimeout(this.#jumpTimer);
          this.#jumpTimer = setTimeout(() => this.#hold({ jump: false }), kJumpMilliseconds);
        } else {
          lastTap = event.timeStamp;
        }
      },
    });
  }

  #listenToButton(button, name) {
    this.#listen(button, {
      begin: () => {
        clearTimeout(this.#jumpTimer);
        button.classList.add('on');
        this.#hold({ [name]: true });
      },
      move: () => {},
      end: () => {
        button.classList.remove('on');
        this.#hold({ [name]: false });
      },
    });
  }

  #listen(element, actions) {
    this.#touches.push(followTouch(element, actions));
  }
}

// Follows one touch at a time on an element, also beyond its edges. `end` gets no event if the
// touch is dropped.
function followTouch(element, { begin, move, end }) {
  let pointer = null;
  const finish = (event) => {
    pointer = null;
    end(event);
  };
  element.addEventListener('pointerdown', (event) => {
    if (pointer !== null) return;
    event.preventDefault();
    pointer = event.pointerId;
    element.setPointerCapture(pointer);
    begin(event);
    move(event);
  });
  element.addEventListener('pointermove', (event) => {
    if (event.pointerId === pointer) move(event);
  });
  for (const type of ['pointerup', 'pointercancel', 'lostpointercapture']) {
    element.addEventListener(type, (event) => event.pointerId === pointer && finish(event));
  }
  return { drop: () => pointer !== null && finish() };
}
