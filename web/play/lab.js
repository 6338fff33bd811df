// The Lab: a sheet beside the picture with everything that shows how it is drawn: overlays, drawing
// column by column, light, old ways of drawing beside the exact one, photo mode and the benchmark.
// It stays open while somebody plays.
//
//     const lab = new Lab(sheet, caster, { settings, photo, benchmark, record, replay, explain });
//     lab.toggle();

import { isFinger } from '../element/details.js';
import { Divider } from './divider.js';
import { findOldWay } from './lab-places.js';
import { optionRow } from './lab-rows.js';

const kRefresh = 300; // milliseconds between two checks for changes by keys

const fixed = (digits) => (value) => value.toFixed(digits);
const ofAll = (value, greatest) => (value >= greatest ? 'all' : String(value));

const kTimesOfDay = {
  map: "The scene's own",
  day: 'Day',
  dusk: 'Dusk',
  night: 'Night',
  fog: 'Fog',
};

const kGroups = [
  {
    title: 'Show',
    rows: [
      { option: 'minimap', label: 'Map from above' },
      { option: 'minimapRays', label: 'Rays on the map' },
      { option: 'minimapTurns', label: 'Map turns with you' },
      { option: 'playerPanel', label: 'Where you are' },
      { option: 'processPanel', label: 'Cost of drawing' },
      { option: 'grid', label: 'Pixel grid' },
    ],
  },
  {
    title: 'One slice in detail',
    rows: [
      { option: 'inspector', label: 'Slice from the side' },
      {
        option: 'inspectorColumn',
        label: 'Column',
        least: 0,
        greatest: (columns) => columns - 1,
        step: 1,
        standard: (columns) => Math.floor(columns / 2),
        shown: String,
      },
      { option: 'slow', label: 'Draw slowly' },
      {
        option: 'drawnColumns',
        label: 'Columns drawn',
        least: 0,
        greatest: (columns) => columns,
        step: 1,
        standard: (columns) => columns,
        shown: ofAll,
      },
    ],
  },
  {
    title: 'Textures',
    rows: [
      { option: 'smooth', label: 'Smooth close up' },
      { option: 'detail', label: 'Smooth far away' },
    ],
  },
  {
    title: 'Light',
    rows: [
      { option: 'lightPreset', label: 'Time of day', choices: kTimesOfDay },
      { option: 'light', label: 'Fades with distance' },
      {
        option: 'intensity',
        label: 'Intensity',
        least: 0,
        greatest: 5,
        step: 0.1,
        standard: (columns, player) => player.intensity,
        shown: fixed(1),
      },
      {
        option: 'multiplier',
        label: 'Reach',
        least: 0,
        greatest: 40,
        step: 0.5,
        standard: (columns, player) => player.multiplier,
        shown: fixed(1),
      },
      { option: 'baked', label: 'Sun and lamps' },
      { option: 'fog', label: 'Fog' },
      {
        option: 'mirrors',
        label: 'Mirrors',
        least: 0,
        greatest: 4,
        step: 0.1,
        shown: (value) => `${value.toFixed(1)} ×`,
      },
    ],
  },
];

const kRows = kGroups.flatMap(({ rows }) => rows);
const kWhole = ['drawnColumns']; // set to -1, for all, at the end of their range

export class Lab {
  #sheet;
  #caster;
  #settings;
  #rows;
  #divider;
  #timer = 0;
  #ways = [];
  #search = null; // for a place that shows an old way

  constructor(sheet, caster, { settings, photo, benchmark, ...others }) {
    this.#sheet = sheet;
    this.#caster = caster;
    this.#settings = settings;
    const find = (name) => sheet.querySelector(`[data-lab="${name}"]`);
    const actions = {
      read: (name, value) => this.#readNumber(name, value),
      write: (name, value) => this.write(name, value),
      columns: () => caster.picture.width,
    };
    this.#rows = kRows.map((spec) => optionRow(spec, actions));
    const groups = kGroups.map(({ title, rows }) => {
      const group = document.createElement('fieldset');
      const legend = document.createElement('legend');
      legend.textContent = title;
      group.append(legend, ...rows.map((spec) => this.#rows[kRows.indexOf(spec)].element));
      return group;
    });
    find('options').replaceChildren(...groups);
    find('photo').addEventListener('click', photo);
    find('benchmark').addEventListener('click', benchmark);
    // These need the whole picture.
    for (const [name, act] of Object.entries(others))
      find(name).addEventListener('click', (press) => {
        this.close();
        act({ touch: isFinger(press) });
      });
    find('close').addEventListener('click', () => this.close());
    find('way').addEventListener('input', ({ target }) => this.#choose(target.value));
    find('way-show').addEventListener('click', () => this.#showWay());
    sheet.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      this.close();
    });
    this.#divider = new Divider(document.getElementById('divider'), caster, (share) =>
      this.write('compare', share),
    );
    caster.addEventListener('ready', () => this.#ready());
  }

  get isOpen() {
    return !this.#sheet.hidden;
  }

  toggle() {
    if (this.isOpen) this.close();
    else this.open();
  }

  open() {
    if (this.#caster.world === null) return;
    this.#sheet.hidden = false;
    document.body.classList.add('lab-open');
    document.getElementById('open-lab').setAttribute('aria-expanded', 'true');
    this.#show();
    this.#timer = setInterval(() => this.#show(), kRefresh);
    this.#sheet.querySelector('input').focus({ preventScroll: true });
  }

  close() {
    clearInterval(this.#timer);
    this.#search?.abort();
    this.#sheet.hidden = true;
    document.body.classList.remove('lab-open');
    const button = document.getElementById('open-lab');
    button.setAttribute('aria-expanded', 'false');
    button.focus({ preventScroll: true });
  }

  // Settings are stored; other options last until the page is closed.
  write(name, value) {
    const isWhole = kWhole.includes(name) && Number(value) >= this.#caster.picture.width;
    const text = isWhole ? '-1' : String(value);
    if (this.#settings.names.includes(name)) this.#settings.take(name, text);
    else this.#caster.set(name, text);
  }

  #readNumber(name, value) {
    const number = Number(value);
    if (value !== null && !(number < 0)) return number;
    const { standard } = kRows.find(({ option }) => option === name);
    return standard === undefined ? 0 : standard(this.#caster.picture.width, this.#caster.player);
  }

  #show() {
    if (this.#caster.world === null) return;
    const options = new Map(this.#caster.optionList.map((option) => [option.name, option]));
    const focused = document.activeElement;
    this.#rows.forEach(({ element, show }) => {
      if (!element.contains(focused) || focused.type === 'checkbox') show(options);
    });
  }

  // ---- Old against exact

  #ready() {
    this.#ways = this.#caster.oldWays;
    const select = this.#sheet.querySelector('[data-lab="way"]');
    const chosen = select.value;
    select.replaceChildren(
      new Option('Off', ''),
      ...this.#ways.map(({ name }) => new Option(name, name)),
    );
    select.value = this.#ways.some(({ name }) => name === chosen) ? chosen : '';
    if (select.value !== '') this.#choose(select.value);
  }

  #choose(name) {
    this.#search?.abort();
    const place = this.#sheet.querySelector('[data-lab="way-place"]');
    place.hidden = name === '';
    place.querySelector('[role="status"]').textContent = '';
    const way = this.#ways.find((known) => known.name === name);
    this.#sheet.querySelector('[data-lab="way-about"]').textContent =
      way?.description ?? 'Choose an old way of drawing to see it beside the exact picture.';
    for (const { name: option, standard } of this.#caster.optionList)
      if (option.startsWith('classic.')) this.#caster.set(option, standard);
    for (const [option, value] of Object.entries(way?.options ?? {}))
      this.#caster.set(option, value);
    const share = way === undefined ? 0 : Number(this.#caster.get('compare')) || 0.5;
    this.#share(share);
  }

  #share(share) {
    this.#caster.set('compare', share);
    this.#divider.show(share);
  }

  // Goes to a place where the chosen way shows, with the divider in the middle.
  async #showWay() {
    this.#search?.abort();
    this.#search = new AbortController();
    const { signal } = this.#search;
    const status = this.#sheet.querySelector('[data-lab="way-place"] [role="status"]');
    status.textContent = 'Searching …';
    const found = await findOldWay(this.#caster, signal);
    if (signal.aborted) return;
    if (found === null) {
      status.textContent = 'No place in this scene shows it.';
      return;
    }
    const { isHere, view } = found;
    if (!isHere) this.#caster.look(view);
    this.#share(0.5);
    status.textContent = isHere ? 'It shows in this view.' : 'You are where it shows.';
  }
}
