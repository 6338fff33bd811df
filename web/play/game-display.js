// Shows a game above the picture: the aim, the finds so far, the time and the best time, and
// messages below. Keeps the best time of each scene.
//
//     new GameDisplay(section, caster, () => 'wayhouse-hunt.json');
//
// The section has #game-aim, #game-count and #game-time; #message is a line of its own. The time is
// that of the engine's steps, from the first input, so a pause costs nothing.

import { bestTime, keepTime } from './best-times.js';
import { timeText } from './time-text.js';

const kInterval = 200; // milliseconds between two looks at the clock
const kLeast = 3500; // milliseconds that a message stays, and how much longer for each character
const kPerCharacter = 55;
const kAimShown = 12; // seconds of the game

export class GameDisplay {
  #section;
  #caster;
  #sceneName;
  #message = document.getElementById('message');
  #timer = 0;
  #interval = 0;
  #best = null; // seconds, of the present scene
  #isNewBest = false;

  constructor(section, caster, sceneName) {
    this.#section = section;
    this.#caster = caster;
    this.#sceneName = sceneName;
    caster.addEventListener('ready', () => this.#begin());
    for (const name of ['message', 'find', 'goal'])
      caster.addEventListener(name, ({ detail }) => this.#tell(name, detail));
  }

  // A scene has loaded, with or without a game.
  #begin() {
    clearInterval(this.#interval);
    this.#say('');
    const game = this.#caster.game;
    this.#section.hidden = game === null || (game.of === 0 && !game.hasGoal && game.aim === '');
    if (this.#section.hidden) return;
    this.#best = bestTime(this.#sceneName());
    this.#isNewBest = false;
    this.#part('aim').textContent = game.aim;
    this.#show();
    this.#interval = setInterval(() => this.#show(), kInterval);
  }

  #show() {
    const game = this.#caster.game;
    if (game === null) return;
    this.#section.dataset.state = game.reached ? 'reached' : game.begun ? 'begun' : 'waiting';
    this.#part('aim').hidden = game.aim === '' || game.reached || game.seconds > kAimShown;
    const count = this.#part('count');
    count.hidden = game.of === 0;
    // One mark for each find, full once it is taken; a number where marks would be too many.
    const text =
      game.of > 12
        ? `${game.finds} of ${game.of}`
        : '◆'.repeat(game.finds) + '◇'.repeat(game.of - game.finds);
    if (count.textContent !== text) {
      count.textContent = text;
      count.setAttribute('aria-label', `${game.finds} of ${game.of} found`);
    }
    this.#part('time').textContent = game.hasGoal ? this.#timeLine(game) : '';
  }

  #timeLine({ seconds, reached }) {
    const now = timeText(seconds);
    if (reached && this.#isNewBest) return `${now}, your best time`;
    return this.#best === null ? now : `${now}, best ${timeText(this.#best)}`;
  }

  #tell(name, detail) {
    if (name === 'goal') {
      const { steps, seconds } = this.#caster.game;
      this.#isNewBest = keepTime(this.#sceneName(), steps);
      if (this.#isNewBest) this.#best = seconds;
    }
    const text = detail.text || (name === 'find' ? `Found: ${detail.name}` : '');
    if (text !== '') this.#say(text);
    if (name === 'find') this.#flash();
    if (!this.#section.hidden) this.#show();
  }

  #say(text) {
    clearTimeout(this.#timer);
    this.#message.classList.toggle('shown', text !== '');
    if (text === '') return;
    this.#message.textContent = text;
    this.#timer = setTimeout(() => this.#say(''), kLeast + kPerCharacter * text.length);
  }

  #flash() {
    const count = this.#part('count');
    count.classList.remove('found');
    void count.offsetWidth; // so that the animation begins anew
    count.classList.add('found');
  }

  #part(name) {
    return document.getElementById(`game-${name}`);
  }
}
