// Two elements that share a view: when either moves, the other one follows.
//
//     const partner = new Partner(show, otherShow);       // the first takes the view of the other
//     partner.stop();

const kFollowingMilliseconds = 150; // how long a view that has just followed does not lead

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
    // Draws in the same frame, but after the leader has requested its next one. So the leader comes
    // first in that frame too, and nothing is drawn twice.
    queueMicrotask(
      () => follower.ready !== null && follower.engine.drawNow(document.timeline.currentTime),
    );
  }
}

function isSame(one, other) {
  return Object.keys(one).every((name) => one[name] === other[name]);
}
