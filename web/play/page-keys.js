// The keys that are the page's: those that the element leaves to it or asks it about while somebody
// plays, and a few that act while nothing has the focus.

const kShareCode = 'KeyZ'; // the engine knows none for it

// By the names of their actions, so that a key bound anew does the same. While somebody plays, too:
// the element leaves them to the page.
const kAlways = {
  share: ({ dialogs }) => dialogs.open('share'),
  hits: ({ caster }) => tellHits(caster),
  rate: ({ toggleRate }) => toggleRate(),
  record: ({ toggleRecording }) => toggleRecording(),
};
const kAtRest = {
  help: ({ dialogs }) => dialogs.open('keys'),
  fullscreen: ({ toggleFullScreen }) => toggleFullScreen(),
  pause: goOn,
  enter: goOn,
};

export function listenForPageKeys(caster, actions) {
  const all = { caster, ...actions };
  document.addEventListener('keydown', (event) => {
    const { code, target } = event;
    if (event.defaultPrevented || event.repeat || actions.dialogs.isOpen) return;
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const isNowhere = target === document.body;
    if (!isNowhere && target !== caster) return;
    const name = actionOf(caster, code);
    const isCovers = name === 'enter' && !isNowhere; // the picture's own affair
    const act = kAlways[name] ?? (caster.entered || isCovers ? undefined : kAtRest[name]);
    if (act === undefined || caster.world === null) return;
    event.preventDefault();
    act(all);
  });
  // H and F of who plays.
  caster.addEventListener('request', (event) => {
    event.preventDefault();
    if (event.detail.wish === 'help') actions.dialogs.open('keys');
    else actions.toggleFullScreen();
  });
}

function actionOf(caster, code) {
  if (code === kShareCode) return 'share';
  if (code === 'Enter') return 'enter';
  const actions = caster.keyList.flatMap((line) => line.actions);
  return actions.find(({ keys }) => keys.some((key) => key.code === code))?.name;
}

function goOn({ caster }) {
  if (caster.state !== 'error') caster.enter();
}

// What the inspected slice meets, on the console.
function tellHits(caster) {
  const { width } = caster.picture;
  const chosen = Number(caster.get('inspectorColumn'));
  const column = chosen >= 0 && chosen < width ? chosen : Math.floor(width / 2);
  console.info('slice %d', column, caster.hits(column));
}
