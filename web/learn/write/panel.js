// The panel "Write your own": README.md says how a page mounts it.
//
// What is shown, what is kept and what runs is decided by the desk (desk.js); everything that a run
// gives goes through `#show`.

import { expectations } from '../raycaster/checks.js';
import { difference, taught } from '../raycaster/compare.js';
import { functionsOf } from '../raycaster/states.js';
import { showImage } from '../figures/show-image.js';
import { carry } from './carry.js';
import { newLines, paint } from './code.js';
import { Desk } from './desk.js';
import { button, carefulButton, make, percent, words } from './make.js';
import { makeParts } from './parts.js';
import {
  differenceReport,
  functionList,
  isSolved,
  paintDifference,
  pixelReport,
} from './results.js';
import { ProgramError, Runner } from './runner.js';
import { codeIn, codeOf, textOf } from './share.js';
import { steer } from './steering.js';
import { Shelf } from './storage.js';

const kSize = { width: 320, height: 200 };
const kTypingMilliseconds = 600;
const kCompareMilliseconds = 200; // after the last move of the eye
const kStepsPerSecond = 120; // of the engine
const kMovesFrom = 17; // the chapter of gates and lifts
const kMostLook = 0.5; // picture heights
const kObjects = 15; // the chapter of objects
const kWalksFrom = 11; // the chapter that writes `move`
const kBodyRadius = 0.2;
const kToMend = '// Yours to mend'; // begins the comment of such a function

export function mountPanel(element, options = {}) {
  const { chapter, scene, view, options: engineOptions, seconds = '0' } = element.dataset;
  const panel = new Panel(element, {
    chapter: Number(chapter),
    scene,
    view,
    engineOptions,
    seconds: Number(seconds),
    folder: 'write/',
    storage: ownStorage(),
    ...options,
  });
  return panel.handle;
}

// A browser may forbid it.
function ownStorage() {
  try {
    return localStorage;
  } catch {
    return null;
  }
}

class Panel {
  #element;
  #settings;
  #shelf;
  #desk;
  #step; // of steps/NN.json
  #editor = null;
  #loading = null; // the promise of the editor
  #runner;
  #world = null; // the promise of the scene's data
  #typing = 0; // timers
  #settling = 0;
  #links = 0; // that the address has had
  #drawing = false;
  #drawAgain = false;
  #last = null; // the last picture
  #checks = [];
  #hints = new Map(); // function -> hints shown
  #solved = false;
  #parts = {};

  constructor(element, settings) {
    this.#element = element;
    this.#settings = settings;
    this.#shelf = new Shelf(settings.storage);
    this.#desk = new Desk(this.#shelf, settings.chapter);
    this.#runner = new Runner(element, new URL('run.html', this.#folder).href);
    const ready = this.#begin();
    ready.catch((error) => this.#say(`The panel cannot start: ${error.message}`));
    this.handle = {
      ready,
      run: () => {
        this.#desk.ask();
        return this.#run();
      },
      look: (view) => this.#look(view),
      close: () => this.#close(),
    };
    Object.defineProperty(this.handle, 'text', { get: () => this.#desk.text });
  }

  get #folder() {
    return new URL(this.#settings.folder, document.baseURI);
  }
  get #chapter() {
    return this.#settings.chapter;
  }

  // ---- Start

  async #begin() {
    const number = String(this.#chapter).padStart(2, '0');
    const answer = await fetch(new URL(`steps/${number}.json`, this.#folder));
    if (!answer.ok) throw new Error(`there is no step ${number} (${answer.status}).`);
    this.#step = await answer.json();
    this.#build();
    this.#openText();
    addEventListener('hashchange', this.#onHash);
    addEventListener('pagehide', this.#onLeave);
    await this.#openLink();
    await this.#parts.caster.whenReady();
    this.#home = this.#parts.caster.currentView;
    this.#passTime(this.#settings.seconds);
    await this.#run();
  }
  #home = null;

  #close() {
    clearTimeout(this.#typing);
    clearTimeout(this.#settling);
    removeEventListener('hashchange', this.#onHash);
    removeEventListener('pagehide', this.#onLeave);
    this.#runner.close();
    this.#editor?.destroy();
  }

  #onHash = () => this.#openLink();
  #onLeave = () => this.#desk.leave();

  // The reader's own text, or ours.
  #openText() {
    const { start } = this.#step;
    const kept = this.#shelf.open(this.#chapter);
    const isOwn = kept?.from === this.#chapter;
    const ours = kept === null ? start : carry(kept.text, this.#step);
    this.#desk.open({ text: isOwn ? kept.text : ours, isOwn, mayRun: !kept?.unfinished });
    this.#setText();
    if (kept === null) {
      const before = this.#shelf.before(this.#chapter);
      if (before > 0)
        this.#note(`You have a program of chapter ${before}; this is our state.`, [
          button(`Bring mine`, () => this.#bring(before)),
        ]);
    } else if (!isOwn) {
      this.#note(
        `Your functions of chapter ${kept.from} are in this program. ` +
          'Those that this chapter adds or changes are ours.',
        [button('Start from our state', () => this.#put(start, 'Carried over'))],
      );
    }
    if (kept?.unfinished)
      this.#note(
        'This program did not come to its end last time, so it waits for you.',
        [button('Run it', () => this.#press())],
        { until: 'run' },
      );
  }

  #bring(chapter) {
    const kept = this.#shelf.open(chapter);
    this.#put(carry(kept.text, this.#step), 'Our state');
  }

  // A program in the address is shown, and waits.
  async #openLink() {
    const link = ++this.#links;
    const code = codeIn(location.hash);
    if (code === null) return;
    try {
      const text = await textOf(code);
      if (link !== this.#links) return; // the address has another by now
      this.#desk.bring(text);
      this.#setText();
      this.#noteLink();
    } catch (error) {
      if (link === this.#links) this.#note(error.message);
    }
  }

  #noteLink() {
    const { isWaiting } = this.#desk;
    const back = button('Back to my program', () => {
      this.#change(() => this.#desk.back());
      this.#setText();
      this.#run();
    });
    this.#note(
      `This program came with a link. ${isWaiting ? 'It runs only when you press Run.' : 'It is not kept unless you change it.'}`,
      isWaiting ? [button('Run it', () => this.#press()), back] : [back],
    );
  }

  // Whatever takes the place of a link's program; the address is then the page's again.
  #change(act) {
    const { whose } = this.#desk;
    act();
    if (whose !== 'link' || this.#desk.whose === 'link') return;
    history.replaceState(null, '', location.pathname + location.search);
    this.#note('');
  }

  // ---- The text

  // What the desk has now.
  #setText() {
    const { text } = this.#desk;
    if (this.#editor === null) this.#paint(text);
    else this.#editor.replace(text);
    clearTimeout(this.#typing);
  }

  // Before there is an editor: from the first function that is the reader's to mend.
  #paint(text) {
    const { code, pre } = this.#parts;
    // What the page came with is coloured already.
    if (code.textContent.trimEnd() !== text.trimEnd()) paint(code, text);
    const lines = text.split('\n');
    const first = lines.findIndex((line) => line.startsWith(kToMend));
    pre.scrollTop = first < 0 ? 0 : ((first - 1) / lines.length) * code.offsetHeight;
  }

  // Another text in place of the reader's, which stays at hand.
  #put(text, why) {
    let undo;
    this.#change(() => (undo = this.#desk.put(text, why)));
    this.#setText();
    this.#note('Another text is in place of yours.', [
      button('Undo', () => {
        this.#change(undo);
        this.#setText();
        if (this.#desk.whose === 'link') this.#noteLink();
        else this.#note('');
        this.#run();
      }),
    ]);
    this.#run();
  }

  // `from`: a click, whose place becomes the cursor's.
  #edit(from = null) {
    this.#loading ??= this.#loadEditor();
    return this.#loading.then(() => {
      if (from !== null) this.#editor.goToPoint(from.clientX, from.clientY);
      return this.#editor;
    });
  }

  async #loadEditor() {
    const { pre, host } = this.#parts;
    host.classList.add('loading');
    try {
      const { makeEditor } = await import('./editor.js');
      const hadFocus = document.activeElement === pre;
      const top = pre.scrollTop;
      const place = make('div', { class: 'write-editor' });
      pre.replaceWith(place);
      this.#editor = makeEditor(place, {
        text: this.#desk.text,
        label: 'Your program',
        describedBy: 'Tab leaves the editor. Control and ] indent. Control and Enter run.',
        onChange: () => this.#onTyping(),
        onRun: () => this.#press(),
      });
      this.#editor.scrollTop = top;
      this.#markErrors();
      if (hadFocus) this.#editor.focus();
    } catch {
      this.#loading = null;
      this.#say('The editor cannot be loaded. Is the network there?');
    } finally {
      host.classList.remove('loading');
    }
  }

  #onTyping() {
    this.#change(() => this.#desk.type(this.#editor.text));
    clearTimeout(this.#typing);
    this.#typing = setTimeout(() => {
      this.#desk.rest(this.#editor.parses);
      this.#run();
    }, kTypingMilliseconds);
  }

  // ---- Runs

  #press() {
    this.#change(() => this.#desk.press());
    if (this.#desk.whose === 'link') this.#noteLink();
    return this.#run();
  }

  // Runs what the desk gives out.
  async #run() {
    let text = this.#desk.begin();
    if (text === null) return;
    this.#parts.run.setAttribute('aria-disabled', 'true');
    for (; text !== null; text = this.#desk.begin()) {
      clearTimeout(this.#typing);
      const isStopped = await this.#runOnce(text);
      this.#desk.end({ isStopped });
    }
    this.#parts.run.removeAttribute('aria-disabled');
    if (this.#drawAgain) this.#follow();
  }

  // Returns whether the program was stopped.
  async #runOnce(text) {
    if (this.#parts.note.dataset.until === 'run') this.#note('');
    let error = null;
    try {
      const { caster } = this.#parts;
      this.#world ??= import('./scene-data.js').then(({ readScene }) =>
        readScene(this.#settings.scene),
      );
      const [{ scene, images }] = await Promise.all([this.#world, caster.whenReady()]);
      const names = [...new Set([...this.#step.names, ...namesIn(text)])];
      this.#isAlive = false;
      await this.#runner.ask('run', { text, names, scene, images });
      this.#isAlive = true;
      await this.#draw();
      await this.#judge();
    } catch (problem) {
      error = problem;
    }
    if (isStop(error)) this.#isAlive = false;
    await this.#showError(error, text);
    if (this.#shelf.fails && this.#desk.whose === 'reader')
      this.#note('This browser does not keep your program: download it before you leave.');
    return isStop(error);
  }

  #isAlive = false; // the program runs, and can be asked

  get #source() {
    const { caster } = this.#parts;
    return {
      eye: caster.currentView,
      fov: Number(caster.get('fov')),
      size: kSize,
      seconds: this.#seconds,
      trace: (columns) => caster.trace(columns),
    };
  }

  async #draw() {
    const { eye: view, fov, seconds } = this.#source;
    const { picture } = await this.#runner.ask('draw', { view, fov, seconds, ...kSize });
    this.#last = { ...picture, view };
    const image = new ImageData(picture.data, picture.width, picture.height);
    showImage(this.#parts.mine, image);
    this.#parts.mineFigure.classList.remove('stale');
  }

  async #judge() {
    const expected = expectations(this.#chapter, this.#source);
    const { checks } = await this.#runner.ask('check', { chapter: this.#chapter, expected });
    this.#checks = checks;
    await this.#compare();
  }

  // The last picture with the engine's, where the chapters so far say what it shows.
  async #compare() {
    const { caster, difference: canvas } = this.#parts;
    const mine = this.#last;
    if (mine === null) return;
    const { eye: view, fov, seconds } = this.#source;
    const engine = caster.pixels(kSize);
    const traces = caster.trace({ first: 0, last: kSize.width - 1 });
    const mask = taught(this.#chapter, traces, kSize, await this.#ownWorld());
    const pixels = difference(mine, engine, mask);
    paintDifference(canvas, mine.data, pixels.map, mask);
    let first = null;
    if (pixels.first !== null) {
      const traced = [traces[pixels.first.column]];
      const place = { chapter: this.#chapter, view, fov, seconds };
      const detail = { ...place, mine, engine, mask, traces: traced };
      first = (await this.#runner.ask('explain', detail)).difference;
    }
    const isEmpty = mine.data.every((byte, index) => byte === 0 || index % 4 === 3);
    this.#show({ ...pixels, isEmpty }, first);
  }

  // A world of the page, which only the comparison of objects needs.
  async #ownWorld() {
    if (this.#chapter !== kObjects) return null;
    const [{ scene, images }, { makeWorld }] = await Promise.all([
      this.#world,
      import('../raycaster/world.js'),
    ]);
    this.#objectWorld ??= makeWorld(scene, images);
    return this.#objectWorld;
  }
  #objectWorld = null;

  // ---- The eye

  #look(view) {
    this.#parts.caster.look(view);
    this.#follow();
  }

  // Lets the engine's gates and lifts stand where they are after so many seconds.
  #passTime(seconds) {
    const { caster } = this.#parts;
    const view = caster.currentView;
    if (seconds < this.#seconds) {
      caster.reset();
      this.#seconds = 0;
    }
    const steps = Math.round((seconds - this.#seconds) * kStepsPerSecond);
    if (steps === 0) return;
    caster.step(steps);
    this.#seconds = seconds;
    caster.look(view);
  }
  #seconds = 0;

  // Draws both pictures again, and compares them once the eye rests.
  async #follow() {
    this.#parts.home.hidden = false;
    clearTimeout(this.#settling);
    if (!this.#isAlive && !this.#desk.isRunning) return;
    if (this.#drawing || this.#desk.isRunning) {
      this.#drawAgain = true;
      return;
    }
    this.#drawing = true;
    try {
      do {
        this.#drawAgain = false;
        await this.#draw();
      } while (this.#drawAgain);
      await this.#showError(null, this.#desk.text);
      this.#settling = setTimeout(
        () => this.#judge().catch((error) => this.#fail(error)),
        kCompareMilliseconds,
      );
    } catch (error) {
      await this.#fail(error);
    } finally {
      this.#drawing = false;
    }
  }

  // A program that ran before can fail in another view.
  #fail(error) {
    if (isStop(error)) this.#isAlive = false;
    return this.#showError(error, this.#desk.text);
  }

  async #walk(ahead, aside) {
    const { caster } = this.#parts;
    const view = caster.currentView;
    if (this.#isAlive && this.#chapter >= kWalksFrom && namesIn(this.#desk.text).includes('move')) {
      if (this.#moving) return;
      this.#moving = true;
      try {
        this.#look((await this.#runner.ask('move', { view, ahead, aside })).view);
      } catch (error) {
        await this.#fail(error);
      } finally {
        this.#moving = false;
      }
      return;
    }
    // Until the reader writes `move`: as far as there is room.
    const turn = (Math.atan2(aside, ahead) * 180) / Math.PI;
    const heading = (view.heading + turn + 720) % 360;
    const { map, x, y, z } = view;
    const room = caster.cast({ map, x, y, z, heading }).end.distance - kBodyRadius;
    const way = Math.max(0, Math.min(Math.hypot(ahead, aside), room));
    const angle = (heading * Math.PI) / 180;
    this.#look({ ...view, x: x + way * Math.cos(angle), y: y + way * Math.sin(angle) });
  }
  #moving = false;

  // ---- What is shown

  #show(pixels, first) {
    const { pixelBox, firstBox, difference: canvas } = this.#parts;
    canvas.closest('figure').hidden = pixels.all === 0;
    this.#showFunctions();
    pixelBox.replaceChildren(...pixelReport(pixels));
    firstBox.replaceChildren(...differenceReport(first, (column) => this.#markColumn(column)));
    this.#markColumn(null);
    const right = this.#checks.filter(({ ok }) => ok).length;
    const wrong = this.#checks.find(({ ok }) => !ok);
    const firstWrong = wrong === undefined ? '' : ` ${wrong.says.replaceAll('`', '')}.`;
    const solved = isSolved(this.#checks, pixels);
    const share = pixels.all === 0 ? '' : ` ${percent(pixels.share)} of the pixels are equal.`;
    const done = solved ? ' This step is done.' : '';
    this.#say(
      `${right} of ${this.#checks.length} functions are right.${firstWrong}${share}${done}`,
      solved ? 'solved' : '',
    );
    this.#emit('write-run', { equal: pixels.share, checks: this.#checks });
    if (solved && !this.#solved) this.#emit('write-solved', {});
    this.#solved ||= solved;
  }

  #showFunctions() {
    const { functions } = this.#parts;
    const list = functionList(this.#step, this.#checks, this.#hints, (name, count) => {
      this.#hints.set(name, count);
      this.#showFunctions();
      const row = functions.querySelector(`[data-name="${name}"]`);
      (row.querySelector('button') ?? row.querySelector('pre')).focus();
    });
    functions.replaceChildren(list);
  }

  #emit(name, detail) {
    const event = { bubbles: true, detail: { chapter: this.#chapter, ...detail } };
    this.#element.dispatchEvent(new CustomEvent(name, event));
  }

  #showError(error, text) {
    return this.#explain(error, text).catch(({ message }) => this.#say(message, 'wrong'));
  }

  async #explain(error, text) {
    const { errorBox } = this.#parts;
    if (error !== null && !(error instanceof ProgramError)) console.error(error);
    if (!(error instanceof ProgramError) || error === null) {
      errorBox.replaceChildren(...(error === null ? [] : [`${error.message}`]));
      errorBox.hidden = error === null;
      this.#errors = [];
      if (error === null) await this.#suspect(text);
      return this.#markErrors();
    }
    const { explain } = await import('./errors.js');
    const { says, raw, line, column } = explain(error, text);
    const where =
      line > 0
        ? [
            button(`Line ${line}`, () => this.#edit().then((editor) => editor.goTo(line, column)), {
              class: 'write-line',
            }),
          ]
        : [];
    const detail = raw === '' ? [] : [make('code', { class: 'write-raw' }, raw)];
    errorBox.replaceChildren(...where, make('p', {}, ...words(says)), ...detail);
    errorBox.hidden = false;
    this.#parts.mineFigure.classList.add('stale');
    this.#say(`${line > 0 ? `Line ${line}: ` : ''}${says.replaceAll('`', '')}`, 'wrong');
    this.#errors = [{ line, column, says: says.replaceAll('`', '') }];
    return this.#markErrors();
  }
  #errors = [];

  async #suspect(text) {
    if (!/\b(?:if|while|for)\b/.test(text)) return;
    const { suspicions } = await import('./errors.js');
    this.#errors = suspicions(text).map((each) => ({
      ...each,
      says: each.says.replaceAll('`', ''),
      severity: 'warning',
    }));
  }

  #markErrors() {
    this.#editor?.mark(this.#errors);
  }

  // The state of things, in a line that is read out.
  #say(text, kind = '') {
    const { status } = this.#parts;
    if (status === undefined) return;
    status.className = `write-status ${kind}`;
    if (status.textContent !== text) status.textContent = text;
  }

  #tell(work) {
    work.catch(({ message }) => this.#say(message, 'wrong'));
  }

  // A note above the program, with what can be done about it.
  #note(text, buttons = [], { until = '' } = {}) {
    const { note } = this.#parts;
    note.hidden = text === '';
    note.dataset.until = until;
    note.replaceChildren(...(text === '' ? [] : [make('p', {}, text), ...buttons]));
  }

  #markColumn(column) {
    for (const mark of this.#element.querySelectorAll('.write-column')) {
      mark.hidden = column === null;
      if (column !== null) mark.style.left = `${(100 * (column + 0.5)) / kSize.width}%`;
    }
    if (column !== null) this.#parts.mine.scrollIntoView({ block: 'nearest', inline: 'nearest' });
  }

  // ---- The parts

  #build() {
    const { engineOptions: options, scene, view, seconds } = this.#settings;
    const acts = {
      edit: (event) => this.#edit(event),
      run: () => this.#press(),
      start: () => this.#put(this.#step.start, 'Before our state'),
      answer: () => this.#showAnswer(),
      earlier: () => this.#showEarlier(),
      share: () => this.#tell(this.#share()),
      download: () => this.#tell(this.#download()),
      home: () => this.#goHome(),
      time: (now) => {
        this.#passTime(now);
        this.#follow();
      },
    };
    const time = this.#chapter >= kMovesFrom ? seconds : null;
    this.#parts = makeParts(this.#element, { size: kSize, scene, view, options, time, acts });
    const { stick, steps, caster } = this.#parts;
    steer(stick, steps, {
      turn: (degrees) => this.#turn({ heading: degrees }),
      look: (share) => this.#turn({ look: share }),
      walk: (ahead, aside) => this.#walk(ahead, aside),
      home: acts.home,
    });
    caster.addEventListener('error', ({ detail }) => this.#say(detail.message));
  }

  #turn({ heading = 0, look = 0 }) {
    const now = this.#parts.caster.currentView;
    if (now === null) return;
    const limited = Math.min(kMostLook, Math.max(-kMostLook, now.look + look));
    this.#look({ heading: (now.heading + heading + 360) % 360, look: limited });
  }

  #goHome() {
    this.#look(this.#home);
    this.#parts.home.hidden = true;
  }

  // ---- Answer, earlier versions, sharing

  // The answer beside the program: its lines that the reader's program lacks are marked.
  #showAnswer() {
    const { answer: box } = this.#parts;
    if (!box.hidden) {
      box.hidden = true;
      return;
    }
    const { answer } = this.#step;
    const code = make('code');
    const fresh = newLines(this.#desk.text, answer);
    paint(code, answer, (index) => fresh.has(index));
    const close = button('Close', () => {
      box.hidden = true;
    });
    box.replaceChildren(
      make('h3', {}, 'The answer'),
      make('p', {}, 'Lines that your program does not have are marked.'),
      make('pre', { tabindex: '0', 'aria-label': 'The answer' }, code),
      make(
        'div',
        { class: 'write-tools' },
        carefulButton(
          'Put it in place of mine',
          'Really? Mine goes to the earlier versions',
          () => {
            box.hidden = true;
            this.#put(answer, 'Before the answer');
          },
        ),
        close,
      ),
    );
    box.hidden = false;
    const pre = box.querySelector('pre');
    pre.scrollTop = (box.querySelector('mark')?.offsetTop ?? 0) - pre.clientHeight / 3;
    pre.focus();
  }

  #showEarlier() {
    const { earlier: box } = this.#parts;
    box.hidden = !box.hidden;
    const versions = this.#shelf.earlier(this.#chapter);
    const list = versions.map(({ text, time, why }) =>
      make(
        'li',
        {},
        `${why}, ${new Date(time).toLocaleString([], { dateStyle: 'short', timeStyle: 'short' })} `,
        button('Bring back', () => {
          box.hidden = true;
          this.#put(text, 'Before an earlier version');
        }),
      ),
    );
    box.replaceChildren(
      make('h3', {}, 'Earlier versions'),
      versions.length === 0
        ? make('p', {}, 'There are none yet. What a button replaces is kept here.')
        : make('ul', {}, ...list),
    );
  }

  async #share() {
    const { share: box } = this.#parts;
    const page = `${location.origin}${location.pathname}${location.search}`;
    const address = `${page}#program=${await codeOf(this.#desk.text)}`;
    const field = make('input', { readonly: true, value: address, id: 'write-address' });
    field.addEventListener('focus', () => field.select());
    box.replaceChildren(
      make('label', { for: 'write-address' }, 'Your program as a link'),
      field,
      make(
        'p',
        { class: 'write-detail' },
        'Whoever opens it sees your program, and runs it by a button.',
      ),
    );
    box.hidden = false;
    try {
      await navigator.clipboard.writeText(address);
      box.querySelector('label').append(' (copied)');
    } catch {
      field.focus();
    }
  }

  async #download() {
    const { exportPage } = await import('./export.js');
    this.#world ??= import('./scene-data.js').then(({ readScene }) =>
      readScene(this.#settings.scene),
    );
    const { eye: view, fov } = this.#source;
    const page = await exportPage(new URL('export.html', this.#folder), {
      text: this.#desk.text,
      data: await this.#world,
      view,
      fov,
      chapter: this.#chapter,
    });
    const address = URL.createObjectURL(new Blob([page], { type: 'text/html' }));
    make('a', { href: address, download: `raycaster-${this.#chapter}.html` }).click();
    setTimeout(() => URL.revokeObjectURL(address), 10000);
  }
}

// The frame has ended the program.
const isStop = (error) => error instanceof ProgramError && error.kind !== 'error';

function namesIn(text) {
  return functionsOf(text).map(({ name }) => name);
}
