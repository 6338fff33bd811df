// Who steers a <ray-caster>: nobody, until a click, a tap or Enter on its cover gives the picture
// the keys; Escape, another focus or the leave button takes them back. Tab is never kept, and what
// the picture does not use goes on to the page.
//
//     const activation = new Activation(tree, {canBegin() {...}, changed(isHeld) {...}, engine() {...}});
//     activation.begin();          // as a click on the cover does, which has the focus
//     activation.end();            // the cover gets the focus if the picture had it, and with {focus: true} in any case
//     activation.setKeys('move');

import { Gamepads } from './gamepads.js';
import { Thumbs } from './thumbs.js';
import { touchLayer } from './touch.js';

const kMovingGroups = ['move', 'gates']; // of the engine's actions (src/app/actions.h)
const kMovingActions = /^map\d$/;

// The stick by which one looks around, and nothing else.
const onlyLooking = (pad) => ({
  ...pad,
  leftX: 0,
  leftY: 0,
  leftTrigger: 0,
  rightTrigger: 0,
  buttons: 0,
});

export class Activation {
  keys = 'all';
  interaction = 'walk';
  isHeld = false;
  #byTouch = false; // the last one began by a finger: then there are thumbs, also when the window gets the focus back
  #wish = null; // of who has pressed the cover while the scene is still to come; the cover shows that it knows
  #pointerHeld = new AbortController();
  #thumbs = null;
  #layer = null;
  #gamepads = null;
  #moving = new Set(); // codes of keys that are not taken: those by which one would move

  constructor(tree, actions) {
    this.tree = tree;
    this.actions = actions;
    const { box, leave, stage } = tree;
    leave.addEventListener('click', () => this.end({ focus: true }));
    box.addEventListener('keydown', (event) => this.#filter(event), { capture: true });
    box.addEventListener('focusout', ({ relatedTarget }) => {
      if (this.isHeld && !box.contains(relatedTarget)) this.#hold(false);
    });
    // From the cover (begin), or with the window, which has got the focus back.
    stage.addEventListener('focusin', () => {
      if (this.isHeld || !actions.canBegin()) return;
      this.#showThumbs(this.#byTouch);
      this.#hold(true);
    });
  }

  begin({ touch = false, mouse = false } = {}) {
    this.#wish = this.actions.canBegin() ? null : { touch, mouse };
    this.tree.box.classList.toggle('waiting', this.#wish !== null);
    if (this.#wish !== null) return;
    this.#byTouch = touch;
    // The focus goes straight from the cover to the picture, which then is held.
    this.takeCanvas();
    this.#target.focus({ preventScroll: true });
    if (mouse) this.#target.dispatchEvent(new MouseEvent('click'));
  }

  // The scene is there: who pressed the cover before, and is still there, begins now.
  resume() {
    if (this.#wish !== null && this.tree.root.activeElement === this.tree.cover)
      this.begin(this.#wish);
    this.#forget();
  }

  end({ focus = false } = {}) {
    this.#forget();
    if (!this.isHeld) return;
    const { cover, stage, root } = this.tree;
    const hadFocus = focus || stage.contains(root.activeElement);
    this.#hold(false);
    if (hadFocus) cover.focus({ preventScroll: true });
  }

  focus(options) {
    (this.isHeld ? this.#target : this.tree.cover).focus(options);
  }

  // A picture without keys leaves them to the page: it never has the focus itself.
  get #target() {
    return this.keys === 'none' ? this.tree.stage : this.tree.canvas;
  }

  // The picture can be tabbed to only while it is played; before, there is its cover.
  takeCanvas() {
    const { stage, canvas } = this.tree;
    const target = this.#target;
    const other = target === stage ? canvas : stage;
    if (target !== null) target.tabIndex = this.isHeld ? 0 : -1;
    // The focus goes on before its place is none any more; else it is lost, and with it the
    // picture.
    if (this.isHeld && this.tree.root.activeElement === other)
      target.focus({ preventScroll: true });
    other?.removeAttribute('tabindex');
    canvas?.setAttribute('role', this.isHeld ? 'application' : 'img');
  }

  setKeys(keys) {
    if (keys === this.keys) return;
    this.keys = keys;
    this.takeCanvas();
  }

  setInteraction(interaction) {
    if (interaction === this.interaction) return;
    this.interaction = interaction;
    this.tree.box.classList.toggle('looks', interaction === 'look');
    // Whoever walks now must not go on.
    this.end();
  }

  get #looksOnly() {
    return this.interaction === 'look';
  }

  // The codes of the keys by which one goes somewhere, or changes something there.
  #movingKeys() {
    const rows = this.actions
      .engine()
      ?.keys.flatMap(({ group, actions }) =>
        actions
          .filter(({ name }) => kMovingGroups.includes(group) || kMovingActions.test(name))
          .flatMap(({ keys }) => keys),
      );
    return new Set(rows?.map(({ code }) => code));
  }

  #forget() {
    this.#wish = null;
    this.tree.box.classList.remove('waiting');
  }

  #hold(isHeld) {
    const { box, cover, leave, canvas, root } = this.tree;
    this.isHeld = isHeld;
    this.takeCanvas();
    cover.hidden = isHeld;
    box.classList.toggle('engaged', isHeld);
    if (isHeld) {
      this.#moving = this.#looksOnly ? this.#movingKeys() : new Set();
      const { interaction } = this;
      this.#gamepads = new Gamepads({
        change: (pad) =>
          this.actions.engine()?.setGamepad(interaction === 'look' ? onlyLooking(pad) : pad),
      });
    } else {
      this.#gamepads?.stop();
      this.#gamepads = null;
      this.#showThumbs(false);
      if (canvas !== null && root.pointerLockElement === canvas)
        canvas.ownerDocument.exitPointerLock();
    }
    leave.hidden = !isHeld || this.#layer?.isConnected !== true;
    this.actions.changed(isHeld);
  }

  #filter(event) {
    if (!this.isHeld) return;
    if (event.code === 'Escape') {
      // What the picture stands in, a dialog perhaps, is left by the next one.
      event.stopPropagation();
      event.preventDefault();
      this.end({ focus: true });
    }
  }

  // Whether the engine hears of a key; the page has the others.
  takesKey(code) {
    if (this.#moving.has(code)) return false;
    const scope = this.actions.engine()?.keyScope(code);
    return scope === 'move' || (scope === 'element' && this.keys === 'all');
  }

  // ---- Thumbs

  #showThumbs(shown) {
    const { box, leave } = this.tree;
    box.classList.toggle('touched', shown);
    if (!shown) {
      if (this.#layer?.isConnected) this.#thumbs.release();
      this.#layer?.remove();
      return;
    }
    if (this.#layer === null) {
      this.#layer = touchLayer();
      this.#thumbs = new Thumbs(this.#layer, {
        hold: (held) => this.#looksOnly || this.actions.engine()?.setThumbs(held),
        drag: (right, down) => this.actions.engine()?.drag(right, down),
        fly: () => {
          const engine = this.actions.engine();
          engine.flying = !engine.state.flying;
        },
      });
    }
    const { world, state } = this.actions.engine();
    this.#thumbs.hasGates = world.gates > 0;
    this.#thumbs.flying = state.flying;
    leave.before(this.#layer);
  }

  // While the pointer is the picture's, its wheel scrolls nothing.
  set holdsPointer(holds) {
    this.#pointerHeld.abort();
    this.#pointerHeld = new AbortController();
    if (holds)
      this.tree.box.addEventListener('wheel', (event) => event.preventDefault(), {
        passive: false,
        signal: this.#pointerHeld.signal,
      });
  }

  // What the engine says of flying.
  set flying(flying) {
    if (this.#thumbs !== null) this.#thumbs.flying = flying;
  }
}
