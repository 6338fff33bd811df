// Gamepads in the page's menus: the D-pad moves between controls and sets sliders and lists, the
// lower button presses, the right one closes, Start opens the scenes. During play, Start pauses.
//
//     new Gamepads(padMenu(caster, dialogs, () => isAtRest));

const kPress = 0;
const kBack = 1;
const kStart = 9;
const kSteps = { 12: -1, 13: 1, 14: -1, 15: 1 }; // up, down, left, right
const kSideways = [14, 15];
const kPressesAcross = 30; // about so many presses move a slider from end to end

const kControls = 'a[href], button:not(:disabled), input:not(:disabled), select:not(:disabled)';

export function padMenu(caster, dialogs, isAtRest) {
  let before = 0;
  return {
    change({ buttons }) {
      const pressed = buttons & ~before;
      before = buttons;
      if (pressed === 0) return;
      const isDown = (button) => (pressed & (1 << button)) !== 0;
      if (caster.entered) {
        if (isDown(kStart)) caster.pause();
        return;
      }
      if (!dialogs.isOpen && !isAtRest()) return;
      if (isDown(kBack)) dialogs.close();
      else if (isDown(kStart)) dialogs.open('scenes');
      else if (isDown(kPress)) press(caster, dialogs);
      else {
        const button = Object.keys(kSteps).find((number) => isDown(Number(number)));
        if (button !== undefined) step(Number(button));
      }
    },
  };
}

function step(button) {
  const { activeElement } = document;
  if (kSideways.includes(button) && turn(activeElement, kSteps[button])) return;
  const controls = reachable();
  const at = controls.indexOf(activeElement);
  const next = at < 0 ? 0 : (at + kSteps[button] + controls.length) % controls.length;
  controls[next]?.focus();
  controls[next]?.scrollIntoView({ block: 'nearest' });
}

// The controls in order; without a dialog, Play comes first.
function reachable() {
  const open = document.querySelector('dialog[open]');
  const places = open !== null ? [open] : ['#pause', '#bar', '#lab'].map(find);
  return places
    .flatMap((place) => [...place.querySelectorAll(kControls)])
    .filter((control) => control.checkVisibility({ visibilityProperty: true }));
}

const find = (selector) => document.querySelector(selector);

// Sets a slider or a list; returns false for other controls.
function turn(control, by) {
  if (control.type === 'range') {
    const { min, max, step: width } = control;
    const steps = Math.max(1, Math.round((max - min) / width / kPressesAcross));
    if (by > 0) control.stepUp(steps);
    else control.stepDown(steps);
  } else if (control.tagName === 'SELECT') {
    const last = control.options.length - 1;
    control.selectedIndex = Math.min(last, Math.max(0, control.selectedIndex + by));
  } else return false;
  control.dispatchEvent(new Event('input', { bubbles: true }));
  return true;
}

function press(caster, dialogs) {
  const { activeElement } = document;
  if (activeElement.matches(kControls) && activeElement.type !== 'range') activeElement.click();
  else if (!dialogs.isOpen) caster.enter();
}
