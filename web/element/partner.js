// Two views that move together: whoever of the two moves, the other one follows.
//
//     const partner = new Partner(show, otherShow);       // the first one looks from where the other one does, from now on
//     partner.stop();
//
// A show has a host, an engine that is null before there is a scene, and events at the host.

const kFollowingMilliseconds = 150; // so long after it has been led, what moves in a view leads nobody

export class Partner {
  #ended = new AbortController();
  #led = new Map(); // show -> when it was led last

  constructor(show, other) {
    const pairs = [
      [show, other],
      [other, show],
    ];
    const { signal } = this.#ended;
    for (const [one, follower] of pairs) {
      one.host.addEventListener('viewchange', () => this.#lead(one, follower), { signal });
      one.host.addEventListener('ready', () => this.#lead(other, show, true), { signal });
    }
    this.#lead(other, show, true);
  }

  stop() {
    this.#ended.abort();
  }

  #lead(leader, follower, isAlways = false) {
    if (leader.ready === null || follower.ready === null) return;
    const now = performance.now();
    if (!isAlways && now - (this.#led.get(leader) ?? -Infinity) < kFollowingMilliseconds) return;
    const { view } = leader.engine;
    if (isSame(view, follower.engine.view)) return;
    this.#led.set(follower, now);
    if (!follower.engine.look(view)) return;
    follower.engine.flying = leader.engine.state.flying;
    // In the same frame, and after the leader has asked for its next one: so the leader goes first
    // there, and nothing is drawn twice.
    queueMicrotask(
      () => follower.ready !== null && follower.engine.drawNow(document.timeline.currentTime),
    );
  }
}

function isSame(one, other) {
  return Object.keys(one).every((name) => one[name] === other[name]);
}
