// The view, options and overlays that the page's address gives. Such an address shows what somebody
// else saw: options that it does not name are at their standard, whatever the visitor's own
// settings are, and those come back with the next address that gives nothing.
//
//     const given = new GivenOptions(settings);
//     given.take(engine, parameters);          throws a Trouble, and then nothing has changed
//     lookFrom(engine, view);                  of a scene that has just been loaded; throws a Trouble

import { formatView, parseOptions, parseOverlay } from '../engine/address.js';
import { Trouble } from '../engine/trouble.js';

const kGiving = ['view', 'options', 'overlay'];

export class GivenOptions {
  #settings;
  #given = false;

  constructor(settings) {
    this.#settings = settings;
  }

  take(engine, parameters) {
    const gives = kGiving.some((name) => parameters.has(name));
    if (!gives && !this.#given) return;
    const known = engine.options;
    const wanted = new Map(known.map(({ name, standard }) => [name, standard]));
    if (gives) {
      for (const [name, value] of parseOptions(parameters.get('options') ?? ''))
        wanted.set(name, value);
      for (const name of parseOverlay(parameters.get('overlay') ?? '')) wanted.set(name, 'on');
    }
    setAll(engine, known, wanted);
    this.#settings.takeBack();
    this.#given = gives;
    if (gives) {
      for (const { name, kind } of known)
        this.#settings.lend(name, valueOf(kind, wanted.get(name)));
    }
  }
}

function setAll(engine, known, wanted) {
  try {
    for (const [name, value] of wanted) engine.setOption(name, value);
  } catch (error) {
    for (const { name, value } of known) engine.setOption(name, value);
    throw new Trouble('The address gives an option that there is not', error.message);
  }
}

// As the settings keep it.
function valueOf(kind, text) {
  if (kind === 'onOff') return text === 'on';
  return kind === 'number' ? Number(text) : text;
}

// Who looked from the air goes on flying there: whether there is ground is known after a step.
export function lookFrom(engine, view) {
  if (!engine.look(view)) {
    const maps = engine.world.maps.map(({ name }) => name).join(', ');
    throw new Trouble(
      'There is no such view in this scene',
      `view: found "${formatView(view)}", expected an eye above the floor of a map among ${maps}.`,
    );
  }
  engine.step();
  const stands = engine.state.onGround;
  engine.look(view);
  if (!stands) engine.flying = true;
}
