// Whether somebody steers a <ray-caster>. A click, a tap or Enter on its cover gives the picture
// the keys; Escape, moving the focus elsewhere or the leave button takes them back. Tab and keys
// that the picture does not use are left to the page.
//
//     const activation = new Activation(tree, {canBegin() {}, changed(isHeld) {}, engine() {}});
//     activation.begin();          // like a click on the cover, which has the focus
//     activation.end();            // the cover gets the focus if the picture had it
//     activation.end({focus: true});                    // the cover gets it in any case
//     activation.setKeys('move');

import { isFinger } from './details.js';
import { Gamepads } from './gamepads.js';
import { Thumbs } from './thumbs.js';
import { touchLayer } from './touch.js';

const kMovingGroups = ['move', 'gates']; // of the engine's actions (src/app/actions.h)
const kMovingActions = /^map\d$/;

// A gamepad's state with only the stick that looks around.
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
  #byTouch = false; // a finger steers, so thumbs are shown whenever the picture has the focus
  #pending = null; // {touch, mouse} of a press on the cover before the scene had loaded
  #pointerHeld = new AbortController();
  #thumbs = null;
  #layer = null;
  #gamepads = null;
  #moving = new Set(); // codes of keys that move and are left to the page (interaction="look")

  constructor(tree, actions) {
    this.tree = tree;
    this.actions = actions;
    const { box, leave, stage } = tree;
    leave.addEventListener('click', () => this.end({ focus: true }));
    box.addEventListener('keydown', (event) => this.#filter(event), { capture: true });
    box.addEventListener('focusout', ({ relatedTarget }) => {
      if (this.isHeld && !box.contains(relatedTarget)) this.#hold(false);
    });
    stage.addEventListener('pointerdown', (event) => this.#takeOver(event));
    // What acts on the picture does not reach the page: it may turn its slides by swiping.
    for (const type of ['touchstart', 'touchmove', 'touchend', 'touchcancel'])
      stage.addEventListener(type, (event) => this.isHeld && event.stopPropagation());
    // The focus comes from the cover (begin), or returns with the window.
    stage.addEventListener('focusin', () => {
      if (this.isHeld || !actions.canBegin()) return;
      this.#showThumbs(this.#byTouch);
      this.#hold(true);
    });
  }

  begin({ touch = false, mouse = false } = {}) {
    this.#pending = this.actions.canBegin() ? null : { touch, mouse };
    this.tree.box.classList.toggle('waiting', this.#pending !== null);
    if (this.#pending !== null) return;
    this.#byTouch = touch;
    // Moving the focus from the cover to the picture starts steering.
    this.takeCanvas();
    this.#target.focus({ preventScroll: true });
    if (mouse) this.#target.dispatchEvent(new MouseEvent('click'));
  }

  // The scene has loaded: begins if somebody pressed the cover and it still has the focus.
  resume() {
    if (this.#pending !== null && this.tree.root.activeElement === this.tree.cover)
      this.begin(this.#pending);
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

  // With keys="none" the canvas never gets the focus, so all keys go to the page.
  get #target() {
    return this.keys === 'none' ? this.tree.stage : this.tree.canvas;
  }

  // Tab reaches the picture only while somebody steers; otherwise it reaches the cover.
  takeCanvas() {
    const { stage, canvas } = this.tree;
    const target = this.#target;
    const other = target === stage ? canvas : stage;
    if (target !== null) target.tabIndex = this.isHeld ? 0 : -1;
    // Moves the focus before its element loses the tabindex: otherwise the focus is lost, which
    // ends steering.
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
    // Somebody who walks now must stop.
    this.end();
  }

  get #looksOnly() {
    return this.interaction === 'look';
  }

  // The codes of keys that move the player or act on gates.
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
    this.#pending = null;
    this.tree.box.classList.remove('waiting');
  }

  // Begins or ends steering.
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

  // Escape ends steering.
  #filter(event) {
    if (!this.isHeld) return;
    if (event.code === 'Escape') {
      // A dialog around the picture must not close too; the next Escape closes it.
      event.stopPropagation();
      event.preventDefault();
      this.end({ focus: true });
    }
  }

  // Whether the engine gets a key; others are left to the page.
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

  // A finger on a picture that the mouse or keys steer brings the thumbs, and is the first of them.
  #takeOver(event) {
    if (!this.isHeld || !isFinger(event)) return;
    const { canvas, leave, root, status } = this.tree;
    event.preventDefault();
    event.stopPropagation();
    if (root.pointerLockElement === canvas) canvas.ownerDocument.exitPointerLock();
    this.#byTouch = true;
    this.#showThumbs(true);
    leave.hidden = false;
    status.textContent = ''; // of the keys
    root
      .elementFromPoint(event.clientX, event.clientY)
      ?.dispatchEvent(new PointerEvent(event.type, event));
  }

  // While the picture holds the pointer, the wheel does not scroll.
  set holdsPointer(holds) {
    this.#pointerHeld.abort();
    this.#pointerHeld = new AbortController();
    const keep = (event) => {
      event.preventDefault();
      event.stopPropagation();
    };
    const { signal } = this.#pointerHeld;
    if (holds) this.tree.box.addEventListener('wheel', keep, { passive: false, signal });
  }

  // The element sets it when the engine reports the event "fly".
  set flying(flying) {
    if (this.#thumbs !== null) this.#thumbs.flying = flying;
  }
}
