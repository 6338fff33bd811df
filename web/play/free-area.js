// Tells the engine how much of the picture's top and bottom the page covers, so that its minimap
// and panels keep clear of the page's own: the bar, facts, notices, the caption, the handle of the
// divider, and what the element shows for thumbs.
//
//     keepPanelsClear(caster);

const kStrip = 48; // CSS pixels: the bar above, a line of a message below; the divider's handle

const find = (id) => document.getElementById(id);

export function keepPanelsClear(caster) {
  const divider = find('divider');
  const keep = () => {
    const { shadowRoot } = caster;
    const picture = shadowRoot.querySelector('[part~="picture"]');
    if (caster.world === null || picture === null) return;
    const { top, bottom, height } = picture.getBoundingClientRect();
    if (height === 0) return;
    const above = [...document.querySelectorAll('#facts > *'), shadowRoot.querySelector('.leave')];
    const below = [
      ...document.querySelectorAll('#notices > .shown, #pause > *'),
      ...shadowRoot.querySelectorAll('.stick, .buttons'),
    ];
    const clear = Math.max(kStrip, ...boxes(above).map((box) => box.bottom));
    divider.style.top = `${clear}px`;
    const first = clear + (divider.hidden ? 0 : kStrip);
    const last = Math.min(
      find('stage').getBoundingClientRect().bottom - kStrip,
      ...boxes(below).map((box) => box.top),
    );
    const share = (pixels) => Math.min(1, Math.max(0, pixels / height)).toFixed(4);
    set(caster, 'overlayTop', share(first - top));
    set(caster, 'overlayBottom', share(bottom - last));
  };
  const observer = new ResizeObserver(keep);
  const texts = document.querySelectorAll('#facts > *, #notices > *, #pause > *');
  for (const element of [caster, divider, ...texts]) observer.observe(element);
  // Notices that begin or end keep their size.
  new MutationObserver(keep).observe(find('notices'), {
    subtree: true,
    attributeFilter: ['class'],
  });
  new MutationObserver(keep).observe(document.body, { attributeFilter: ['class', 'data-state'] });
  for (const event of ['ready', 'enterchange']) caster.addEventListener(event, keep);
}

function set(caster, name, value) {
  if (Number(caster.get(name)) !== Number(value)) caster.set(name, value);
}

// Of those that are shown.
const boxes = (elements) =>
  elements
    .map((element) => element?.getBoundingClientRect())
    .filter((box) => box !== undefined && box.height > 0);
