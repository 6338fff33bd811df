// The style sheet of bar, keys and thumbs, added to that of styles.js.

export const kSheet = `
.box.engaged:focus-within::after { box-shadow: inset 0 0 0 2px var(--accent), inset 0 0 0 4px var(--veil); }

/* ---- The bar. Hidden during play unless the pointer is on it. */

.controls { position: absolute; inset: auto 0 0; display: flex; padding: 0 4px; background: var(--veil); transition: opacity var(--quick); }
.controls button { display: grid; place-items: center; flex: 0 1 44px; min-width: 0; height: 44px; padding: 0; color: var(--soft); background: none; }
.controls button:hover { color: var(--text); box-shadow: inset 0 -2px 0 var(--accent); }
.controls button[aria-pressed="true"] { color: var(--accent); }
.controls button:disabled { opacity: 0.4; cursor: default; box-shadow: none; }
.controls .space { flex: 1; }
.box[data-state="playing"]:not(:hover) .controls:not(:focus-within) { opacity: 0; transition: opacity calc(2 * var(--quick)) 600ms; }
.box[data-state="error"] .controls { display: none; }

/* In small boxes rarely used buttons go first; in tiny ones the whole bar goes. */
@container (max-width: 280px) { .controls :is([data-name="save"], [data-name="share"]) { display: none; } }
@container (max-width: 190px) { .controls [data-name="overlay"] { display: none; } }
@container (max-width: 140px) { .controls [data-name="reset"] { display: none; } }
@container (max-width: 95px) or (max-height: 90px) { .controls { display: none; } }
@container (max-height: 150px) { .controls button { height: 32px; } }
@media print { .controls, .status { display: none; } }

.status { position: absolute; left: 50%; top: 8px; width: max-content; max-width: calc(100% - 16px); transform: translateX(-50%); text-align: center; padding: 4px 12px; font-size: 13px; color: var(--text); background: var(--veil); pointer-events: none; }
.status:empty { padding: 0; }

/* ---- The keys */

.keys .again { position: absolute; top: 14px; right: 20px; }
.keys dl { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(280px, 100%), 1fr)); gap: 4px 24px; margin: 0; }
.keys dl div { display: grid; grid-template-columns: 124px 1fr; align-items: baseline; gap: 8px; }
.keys h3 { margin: 12px 0 4px; font: inherit; color: var(--soft); }
.keys dd { margin: 0; color: var(--soft); }
.keys kbd { display: inline-block; min-width: 24px; margin: 0 4px 2px 0; padding: 0 6px 2px; font: inherit; font-size: 12px; text-align: center; background: color-mix(in srgb, var(--text) 16%, var(--panel)); box-shadow: var(--light); }
@container (max-width: 420px) { .keys .again { top: 6px; right: 12px; } }

/* ---- Touch: only during play by a finger or a pen */

.engaged .stage { touch-action: none; }
.leave { position: absolute; right: 0; top: 0; display: grid; place-items: center; width: 44px; height: 44px; padding: 0; background: var(--veil); }
.touch { position: absolute; inset: 0; touch-action: none; user-select: none; -webkit-user-select: none; -webkit-touch-callout: none; }
.box.touched .controls { display: none; }
.zone { position: absolute; inset: 0 50% 0 0; touch-action: none; }
.zone + .zone { inset: 0 0 0 50%; }
.stick {
  --x: 72px;
  --y: calc(100% - 72px);
  position: absolute;
  left: calc(var(--x) - 56px);
  top: calc(var(--y) - 56px);
  width: 112px;
  height: 112px;
  display: grid;
  place-items: center;
  border: 2px solid rgb(247 241 225 / 0.4);
  border-radius: 50%;
  background: rgb(21 19 28 / 0.28);
  opacity: 0.7;
  pointer-events: none;
  transition: opacity var(--quick);
}
.stick.held { opacity: 1; background: rgb(21 19 28 / 0.45); border-color: rgb(247 241 225 / 0.7); }
.stick.runs { border-color: var(--accent); }
.knob { width: 48px; height: 48px; border-radius: 50%; background: rgb(247 241 225 / 0.75); box-shadow: inset 0 -4px 0 rgb(21 19 28 / 0.25); }
.stick.runs .knob { background: var(--accent); }
.buttons { position: absolute; right: 8px; bottom: 8px; display: grid; grid-template-columns: auto auto; gap: 4px; }
.looks :is(.zone[data-thumb="walk"], .touch .buttons) { display: none; }
.looks .zone + .zone { inset: 0; }
.thumb-button { display: grid; place-items: center; align-content: center; gap: 2px; width: 52px; height: 52px; font-size: 11px; line-height: 14px; font-weight: 600; background: rgb(21 19 28 / 0.5); box-shadow: var(--light); touch-action: none; }
.thumb-button[data-thumb="fly"] { grid-column: 2; }
.thumb-button .icon { width: 24px; height: 24px; }
.thumb-button.on { color: var(--ink); background: var(--accent); }
@container (max-height: 260px) {
  .buttons { grid-template-columns: repeat(4, auto); }
  .thumb-button { width: 44px; height: 44px; }
  .thumb-button span { display: none; }
  .thumb-button[data-thumb="fly"] { grid-column: auto; }
}
/* Both thumbs side by side */
@container (max-width: 320px) {
  .stick { --x: 48px; --y: calc(100% - 48px); left: calc(var(--x) - 36px); top: calc(var(--y) - 36px); width: 72px; height: 72px; }
  .knob { width: 32px; height: 32px; }
  .buttons { grid-template-columns: auto auto; right: 4px; bottom: 4px; gap: 2px; }
  .thumb-button { width: 36px; height: 36px; }
  .thumb-button span { display: none; }
  .thumb-button .icon { width: 16px; height: 16px; }
  .thumb-button[data-thumb="fly"] { grid-column: 2; }
  .leave { width: 36px; height: 36px; }
}

@media (forced-colors: active) {
  .controls, .controls button, .leave, .status:not(:empty), .keys kbd { border: 1px solid ButtonText; color: ButtonText; background: ButtonFace; forced-color-adjust: none; }
  .controls button:is(:hover, [aria-pressed="true"]) { color: HighlightText; background: Highlight; }
  .keys dd { color: CanvasText; background: Canvas; }
  .box.engaged:focus-within::after { outline: 3px solid Highlight; outline-offset: -3px; }
}
`;
