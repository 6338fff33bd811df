// Whether somebody works by finger: as the last press was, or before the first as the device says.
// Puts data-touch on the body, for style sheets.
//
//     isTouch();                       // true by finger
//     listenToFingers((isTouch) => ...);       // when it changes
//     inTouch('Click a block');        // 'Tap a block', if somebody works by finger

const listeners = [];
let isFinger = false;

export const isTouch = () => isFinger;
export const listenToFingers = (listener) => listeners.push(listener);

const kWords = { 'right click': 'a tap with Remove', 'double click': 'double tap', click: 'tap' };
const capital = (word) => word[0].toUpperCase() + word.slice(1);

export function inTouch(text) {
  if (!isFinger) return text;
  return text.replace(/(right |double )?\bclick\b/gi, (found) => {
    const word = kWords[found.toLowerCase()];
    return found[0] === found[0].toLowerCase() ? word : capital(word);
  });
}

function take(isNow) {
  if (isNow === isFinger) return;
  isFinger = isNow;
  document.body.toggleAttribute('data-touch', isNow);
  for (const listener of listeners) listener(isNow);
}

take(matchMedia('(hover: none) and (pointer: coarse)').matches);
// A pen hovers and has a button.
addEventListener('pointerdown', ({ pointerType }) => take(pointerType === 'touch'), true);
