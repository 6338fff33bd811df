// The page's keys: those that the element leaves to the page during play, and a few that work while
// nothing has the focus.

const kShareCode = 'KeyZ'; // sharing is not an action of the engine

// Looked up by the names of actions, so that changed keys work too. These also work during play.
const kAlways = {
  share: ({ dialogs }) => dialogs.open('share'),
  hits: ({ dialogs }) => dialogs.open('slice'),
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
    const isElements = name === 'enter' && !isNowhere; // the element handles it itself
    const act = kAlways[name] ?? (caster.entered || isElements ? undefined : kAtRest[name]);
    if (act === undefined || caster.world === null) return;
    event.preventDefault();
    act(all);
  });
  // H and F during play.
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
