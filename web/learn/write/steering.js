// Turns and walks the eye of a panel: keys and drags on the reader's picture, and four buttons.
//
//     steer(picture, buttons, { turn(degrees), look(share), walk(ahead, aside), home() })

const kTurn = 5; // degrees for a press
const kWalk = 0.25; // units for a press
const kLook = 0.05; // picture heights for a press
const kDegreesAcross = 66; // for a drag over the whole picture

export function steer(picture, buttons, { turn, look, walk, home }) {
  const kKeys = {
    ArrowLeft: () => turn(-kTurn),
    ArrowRight: () => turn(kTurn),
    ArrowUp: () => walk(kWalk, 0),
    ArrowDown: () => walk(-kWalk, 0),
    'Shift+ArrowLeft': () => walk(0, -kWalk),
    'Shift+ArrowRight': () => walk(0, kWalk),
    PageUp: () => look(kLook),
    PageDown: () => look(-kLook),
    Home: home,
  };
  picture.addEventListener('keydown', (event) => {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const act = kKeys[`${event.shiftKey ? 'Shift+' : ''}${event.key}`];
    if (act === undefined) return;
    event.preventDefault();
    act();
  });

  let from = null; // the pointer that drags, { id, x }
  picture.addEventListener('pointerdown', (event) => {
    if (from !== null || event.button !== 0) return;
    from = { id: event.pointerId, x: event.clientX };
    picture.setPointerCapture(event.pointerId);
  });
  picture.addEventListener('pointermove', (event) => {
    if (event.pointerId !== from?.id) return;
    // The world follows the hand.
    turn(((from.x - event.clientX) / picture.clientWidth) * kDegreesAcross);
    from.x = event.clientX;
  });
  for (const end of ['pointerup', 'pointercancel'])
    picture.addEventListener(end, (event) => {
      if (event.pointerId === from?.id) from = null;
    });

  const [left, forward, back, right] = buttons;
  for (const [element, act] of [
    [left, kKeys.ArrowLeft],
    [forward, kKeys.ArrowUp],
    [back, kKeys.ArrowDown],
    [right, kKeys.ArrowRight],
  ])
    element.addEventListener('click', act);
}
