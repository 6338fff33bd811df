// The style of <ray-caster>: adopted style sheets, one set per document, because pages may forbid
// inline styles.
//
//     const styles = new Styles(shadowRoot);
//     styles.size = '640x400';         // a fixed size sets the aspect ratio
//     styles.add(sheet);               // adds the text of a style sheet
//     styles.adopt();                  // after a move to another document
//
// Buttons look like blocks: square, lit from above, on a darker edge. A page sets their colours by
// --ray-caster-accent, --ray-caster-ink (behind the picture and on the accent), --ray-caster-panel
// and --ray-caster-text.

const kSheet = `
:host {
  --accent: var(--ray-caster-accent, #ecc862);
  --ink: var(--ray-caster-ink, #15131c);
  --panel: var(--ray-caster-panel, #221b20);
  --text: var(--ray-caster-text, #f7f1e1);
  --soft: color-mix(in srgb, var(--text) 78%, var(--panel));
  --line: color-mix(in srgb, var(--text) 16%, transparent);
  --veil: color-mix(in srgb, var(--panel) 84%, transparent);
  --light: inset 0 1px 0 rgb(255 255 255 / 0.16), inset 0 -3px 0 rgb(0 0 0 / 0.36);
  --quick: 160ms;
  /* A shadow at the lower edge of scrollable sheets; at the end, a gradient that scrolls with the text covers it. */
  --more: linear-gradient(transparent, var(--panel) 50%) 0 100% / 100% 40px no-repeat local, linear-gradient(transparent, rgb(0 0 0 / 0.5)) 0 100% / 100% 14px no-repeat;
  display: block;
  aspect-ratio: 16 / 10;
  max-width: 100%;
  contain: layout paint style;
  position: relative;
  overflow: hidden;
  color-scheme: dark;
}
:host([hidden]) { display: none; }
:host(:fullscreen) { width: 100%; height: 100%; aspect-ratio: auto; }
@media (prefers-reduced-motion: reduce) { :host { --quick: 0ms; } }

*, *::before, *::after { box-sizing: border-box; }
[hidden] { display: none !important; }
p, h2, ul { margin: 0; padding: 0; }

.box {
  position: absolute;
  inset: 0;
  container-type: size;
  font: 400 14px/1.45 "Segoe UI Variable Text", "Segoe UI", -apple-system, Roboto, Ubuntu, Cantarell, "Noto Sans", "DejaVu Sans Condensed", system-ui, sans-serif;
  letter-spacing: normal;
  text-align: start;
  text-transform: none;
  text-indent: 0;
  text-shadow: none;
  word-spacing: normal;
  writing-mode: horizontal-tb;
  white-space: normal;
  color: var(--text);
  background: var(--ink);
}
.shape { display: block; visibility: hidden; width: 640px; max-width: 100%; height: 0; }
.stage, .poster, .cover { position: absolute; inset: 0; }
.stage { overflow: hidden; }
.stage:focus { outline: none; }
.frame { position: absolute; }
.frame canvas { display: block; width: 100% !important; height: 100% !important; outline: none; image-rendering: crisp-edges; image-rendering: pixelated; }
.frame.filtered canvas { image-rendering: auto; }
.poster { width: 100%; height: 100%; object-fit: cover; transition: opacity calc(2 * var(--quick)); }
.unseen { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
.icon { display: block; width: 16px; height: 16px; fill: currentcolor; shape-rendering: crispedges; }

/* The focus ring, inside the edge, light on dark, so that it shows on any picture */
.box::after { content: ""; position: absolute; inset: 0; pointer-events: none; }
.cover:focus-visible { box-shadow: inset 0 0 0 2px var(--accent), inset 0 0 0 4px var(--veil); }
.box:has(.cover:focus-visible)::after { box-shadow: inset 0 0 0 2px var(--accent), inset 0 0 0 4px var(--veil); }

button { margin: 0; border: 0; border-radius: 0; font: inherit; color: inherit; cursor: pointer; -webkit-tap-highlight-color: transparent; }
button:focus, .message:focus { outline: none; }
button:focus-visible, .message:focus-visible { outline: 2px solid var(--accent); outline-offset: -2px; }

/* ---- The cover: a button as large as the picture. Dragging on it scrolls the page, a tap plays. */

.cover { display: grid; place-items: center; width: 100%; padding: 0; background: none; touch-action: manipulation; outline: none !important; }
.glyph {
  display: grid;
  place-items: center;
  width: 72px;
  height: 72px;
  color: var(--text);
  background: var(--veil);
  box-shadow: var(--light);
  transition: color var(--quick), background-color var(--quick), opacity var(--quick);
}
.glyph .icon { width: 32px; height: 32px; }
.cover:hover .glyph, .cover:focus-visible .glyph, .waiting .glyph { color: var(--ink); background: var(--accent); }
.cover:active .glyph { box-shadow: inset 0 3px 0 rgb(0 0 0 / 0.36); }
.hint { position: absolute; top: 12px; padding: 4px 12px; font-size: 13px; color: var(--text); background: var(--veil); opacity: 0; transition: opacity var(--quick); }
.box[data-state="playing"] .glyph { opacity: 0; }
.box[data-state="playing"] .cover:is(:hover, :focus-visible) .hint { opacity: 1; }
.box[data-state="error"] .cover { display: none; }
@container (max-width: 420px) {
  .glyph { width: 56px; height: 56px; }
}
@container (max-width: 220px) or (max-height: 150px) {
  .glyph { width: 40px; height: 40px; }
  .glyph .icon { width: 16px; height: 16px; }
  .hint { display: none; }
}

/* interaction="none": presses go to the page */
.shut .cover { display: none; }
.shut :is(.stage, .poster) { pointer-events: none; }

/* ---- Hotspots. They can be pressed; their layer cannot. */

.hotspots { position: absolute; overflow: hidden; pointer-events: none; }
.hotspot { position: absolute; width: max-content; translate: -50% -50%; pointer-events: auto; transition: opacity var(--quick), visibility var(--quick); }
.hotspot.covered { opacity: 0; visibility: hidden; }

/* ---- Progress and status */

.progress { position: absolute; inset: auto 0 0; height: 3px; background: var(--veil); }
.progress::before { content: ""; position: absolute; inset: 0; background: var(--accent); transform-origin: left; transform: scaleX(var(--share, 0)); transition: transform var(--quick); }

/* ---- Sheets over the picture: errors and, in steering-styles.js, the keys */

.sheet { position: absolute; inset: 0; display: flex; flex-direction: column; gap: 12px; padding: 20px; overflow: auto; background: var(--more), color-mix(in srgb, var(--panel) 94%, transparent); }
.sheet h2 { font-size: 17px; line-height: 1.3; font-weight: 700; text-wrap: balance; }
.sheet p { max-width: 70ch; color: var(--soft); overflow-wrap: anywhere; text-wrap: pretty; }
.sheet .again { flex: none; align-self: start; min-height: 36px; padding: 4px 16px 6px; font-weight: 600; background: color-mix(in srgb, var(--text) 16%, var(--panel)); box-shadow: var(--light); }
.sheet .again:hover { color: var(--ink); background: var(--accent); }
.message h2 { padding-left: 12px; box-shadow: inset 4px 0 0 #e3835f; }
.message ul { flex: none; list-style: none; border-bottom: 1px solid var(--line); }
.message li { padding: 8px 0; border-top: 1px solid var(--line); overflow-wrap: anywhere; }
.message .place { font-weight: 600; font-variant-numeric: tabular-nums; }
.message .inside { color: var(--soft); font-size: 13px; }
.message .found { color: #f0a183; }
/* If there can be no picture, the poster stays */
.poster:not([hidden]) ~ .message.hopeless { inset: auto 0 0; max-height: 75%; }
@container (max-width: 420px) { .sheet { padding: 12px; gap: 8px; } }
@container (max-width: 240px) or (max-height: 150px) {
  .sheet { padding: 6px 8px; gap: 4px; font-size: 12px; line-height: 1.35; }
  .sheet h2 { font-size: 13px; }
  .message h2 { padding-left: 8px; box-shadow: inset 3px 0 0 #e3835f; }
  .sheet .again { min-height: 28px; padding: 2px 10px 4px; }
}

@media print {
  .cover, .progress { display: none; }
  .box:not(:has(canvas)) { background: none; outline: 1px solid #000; outline-offset: -1px; }
  .box:not(:has(canvas))::before { content: attr(data-label); position: absolute; inset: 0; display: grid; place-items: center; color: #000; }
}

@media (forced-colors: active) {
  .glyph, .hint, .sheet, .sheet .again { border: 1px solid ButtonText; color: ButtonText; background: ButtonFace; forced-color-adjust: none; }
  .cover:is(:hover, :focus-visible) .glyph { color: HighlightText; background: Highlight; }
  .sheet, .sheet p, .message .found, .message .inside { color: CanvasText; background: Canvas; }
  .progress::before { background: Highlight; }
  .cover:focus-visible { outline: 3px solid Highlight !important; outline-offset: -3px; }
}
`;

const sheets = new WeakMap(); // document -> text -> its sheet: one cannot serve two

export class Styles {
  #root;
  #texts = [kSheet];
  #size = 'auto';

  constructor(root) {
    this.#root = root;
    this.adopt();
  }

  set size(size) {
    if (size === this.#size) return;
    this.#size = size;
    this.adopt();
  }

  add(text) {
    this.#texts.push(text);
    this.adopt();
  }

  adopt() {
    const { ownerDocument } = this.#root;
    // A template's, or one without a browser: nothing is seen there.
    if (!ownerDocument.defaultView?.CSSStyleSheet?.prototype.replaceSync) return;
    const make = (text) => {
      const sheet = new ownerDocument.defaultView.CSSStyleSheet();
      sheet.replaceSync(text);
      return sheet;
    };
    if (!sheets.has(ownerDocument)) sheets.set(ownerDocument, new Map());
    const made = sheets.get(ownerDocument);
    for (const text of this.#texts) if (!made.has(text)) made.set(text, make(text));
    const [width, height] = this.#size.split('x');
    const own =
      height === undefined
        ? []
        : [make(`:host { aspect-ratio: ${width} / ${height}; } .shape { width: ${width}px; }`)];
    this.#root.adoptedStyleSheets = [...this.#texts.map((text) => made.get(text)), ...own];
  }
}
