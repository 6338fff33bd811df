// One moment of a figure: its state, and the engine's answers, each asked for once at most.

import { blockName, crossing, eyesOf, placeOf, rowOf, slopeOf } from './geometry.js';
import * as markup from './markup.js';
import { same, sizeOf } from './state.js';

const kHelpers = { ...markup, crossing, rowOf, slopeOf, placeOf, blockName };

export function makeNow(figure, source, state) {
  return new Now(figure, source, state);
}

class Now {
  #kept = new Map();

  constructor(figure, source, state) {
    Object.assign(this, { figure, source, state });
    this.size = sizeOf(figure);
    [this.width, this.height] = this.size;
    this.column = state.column;
    this.row = state.row;
  }

  kept(name, make) {
    if (!this.#kept.has(name)) this.#kept.set(name, make());
    return this.#kept.get(name);
  }

  get eye() {
    return this.kept('eye', () => this.source.view);
  }

  get slice() {
    return this.kept('slice', () => this.source.trace(this.column));
  }

  get eyes() {
    return this.kept('eyes', () => eyesOf(this.slice));
  }

  get pick() {
    return this.kept('pick', () => this.source.pick(this.column, this.row));
  }

  get runIndex() {
    const { row } = this;
    return this.kept('runIndex', () => {
      const { runs } = this.slice;
      const holds = ({ first, last }) => first <= row && row <= last;
      // Layers lie over opaque runs, the nearest over the others.
      const layer = runs.findIndex((run) => run.layer && holds(run));
      return layer >= 0 ? layer : runs.findIndex((run) => holds(run));
    });
  }

  get run() {
    return this.slice.runs[this.runIndex] ?? null;
  }

  // What the figure's scrub goes through.
  get steps() {
    return this.kept('steps', () => {
      const of = scrubOf(this.figure);
      const walk = this.slice.walk.map(({ axis }, index) => ({
        kind: axis ?? 'start',
        of: 'walk',
        index,
      }));
      const runs = this.slice.runs.map(({ what }, index) => ({ kind: what, of: 'run', index }));
      return of === 'walk' ? walk : of === 'runs' ? runs : [...walk, ...runs];
    });
  }

  get step() {
    const { step } = this.state;
    return step === null ? null : (this.steps[step] ?? null);
  }

  get tiles() {
    const { step } = this;
    const { walk } = this.slice;
    return step?.of === 'walk' ? walk.slice(0, step.index + 1) : walk;
  }

  get runs() {
    const { step } = this;
    const { runs } = this.slice;
    if (step === null || scrubOf(this.figure) === 'walk') return runs;
    return step.of === 'run' ? runs.slice(0, step.index + 1) : [];
  }

  get cells() {
    return this.map(this.eye.map).cells;
  }

  get blueprints() {
    return this.map(this.eye.map).blueprints;
  }

  map(name) {
    return this.kept(`map ${name}`, () => {
      const size = this.source.world.maps.find((map) => map.name === name);
      const written = this.source.scene?.maps?.find((map) => map.name === name) ?? {};
      return {
        ...size,
        cells: this.source.cells(name),
        blueprints: new Map(this.source.blueprints(name).map((each) => [each.character, each])),
        objects: written.objects ?? [],
        portals: written.portals ?? [],
        ceiling: written.ceiling ?? null,
        floor: written.floor ?? null,
      };
    });
  }

  // A number in a text that can be dragged: a field, or one of the eye as 'eye.heading'.
  scrubbed(field, content, { from = -1e4, to = 1e4, step = 1 } = {}) {
    const value = valueOf(this.state, field);
    const numbers = `aria-valuemin="${from}" aria-valuemax="${to}" aria-valuenow="${value}"`;
    return `<span class="fig-scrubbed" role="slider" tabindex="0" data-field="${field}" data-step="${step}" aria-label="${markup.escape(field)}" aria-valuetext="${markup.escape(content)}" ${numbers}>${markup.escape(content)}</span>`;
  }
}
Object.assign(Now.prototype, kHelpers);

export function valueOf(state, field) {
  return field.startsWith('eye.') ? state.eye[field.slice(4)] : state[field];
}

export function changeOf(field, value) {
  return field.startsWith('eye.') ? { eye: { [field.slice(4)]: value } } : { [field]: value };
}

// What the scrub goes through: 'walk', 'runs' or 'both'.
function scrubOf(figure) {
  const scrub = (figure.controls ?? []).find(({ kind, of }) => kind === 'scrub' && of !== 'frame');
  return scrub?.of ?? 'both';
}

// ---- What the engine is told

function optionsOf(figure, state) {
  const options = {};
  for (const { option, field } of figure.controls ?? [])
    if (option !== undefined) options[option] = state[field];
  if (state.columns !== null) options.drawnColumns = state.columns;
  return {
    ...options,
    ...(typeof figure.options === 'function' ? figure.options(state) : figure.options),
  };
}

// Brings the engine to `state`; `before` is the one it is in, or null. Returns false if the eye
// cannot be there.
export function apply(figure, source, state, before) {
  setOptions(source, optionsOf(figure, state), before && optionsOf(figure, before));
  return applyWorld(figure, source, state, before);
}

export function setOptions(source, options, before) {
  for (const name of Object.keys(before ?? {}))
    if (!Object.hasOwn(options, name)) source.set(name, source.standard(name));
  for (const [name, value] of Object.entries(options))
    if (value !== before?.[name]) source.set(name, value);
}

// The world and the eye, without options.
export function applyWorld(figure, source, state, before) {
  const inputOf = (of) => (typeof figure.input === 'function' ? figure.input(of) : figure.input);
  const added = before === null ? null : addedEdits(state.edits, before.edits);
  const isTimed = state.time > 0 || before?.time > 0;
  const moves = before === null || !same(state.eye, before.eye);
  const isAnew =
    added === null ||
    (isTimed &&
      (moves ||
        added.length > 0 ||
        state.time !== before.time ||
        !same(inputOf(state), inputOf(before))));
  if (isAnew && (before !== null || source.isUsed)) source.reset();
  if (before === null) figure.setup?.(source);
  for (const [map, level, x, y, character] of isAnew ? state.edits : added) {
    try {
      source.setCell(map, level, x, y, character);
    } catch {
      // An edit of an address that this scene does not allow.
    }
  }
  const isPlaced = !(moves || isAnew) || source.look(state.eye);
  if (isAnew && state.time > 0) source.step(Math.round(state.time), inputOf(state) ?? {});
  return isPlaced;
}

// The edits by which `edits` is longer than `before`, or null if it does not begin like it.
function addedEdits(edits, before) {
  if (edits === before) return [];
  return same(edits.slice(0, before.length), before) ? edits.slice(before.length) : null;
}
