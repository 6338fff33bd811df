// A slow flight through a scene: a closed, smooth path through the points of the scene's entry in
// scenes/index.json, {"seconds": 80, "points": [[x, y, z, heading, look], ...]}: units, degrees,
// screen heights.
//
//     const flight = new Flight(scene.flight);
//     caster.look(flight.at(12.5));      // the view after so many seconds; repeats at the end

export class Flight {
  #seconds;
  #points;
  #ends = []; // where each stretch ends, as a share of the path's length
  #turned; // degrees that the heading turns on one round: a multiple of 360

  constructor({ seconds, points }) {
    this.#seconds = seconds;
    this.#points = withShortTurns(points);
    const [first] = this.#points;
    const last = this.#points.at(-1);
    this.#turned = last[3] + shortTurn(last[3], first[3]) - first[3];
    let length = 0;
    for (let i = 0; i < points.length; ++i) {
      length += distance(this.#point(i), this.#point(i + 1));
      this.#ends.push(length);
    }
    this.#ends = this.#ends.map((end) => end / length);
  }

  // A stretch takes time in proportion to its length, so the pace is even.
  at(seconds) {
    const share = (((seconds / this.#seconds) % 1) + 1) % 1;
    const index = this.#ends.findIndex((end) => share < end);
    const begin = index > 0 ? this.#ends[index - 1] : 0;
    const along = (share - begin) / (this.#ends[index] - begin);
    const near = [-1, 0, 1, 2].map((step) => this.#point(index + step));
    const [x, y, z, heading, look] = near[0].map((_, axis) =>
      catmullRom(...near.map((point) => point[axis]), along),
    );
    return { x, y, z, heading: ((heading % 360) + 360) % 360, look };
  }

  #point(index) {
    const count = this.#points.length;
    const round = Math.floor(index / count);
    const [x, y, z, heading, look] = this.#points[index - round * count];
    return [x, y, z, heading + round * this.#turned, look];
  }
}

// Returns -180 to 180 degrees.
function shortTurn(from, to) {
  return ((((to - from) % 360) + 540) % 360) - 180;
}

// Adjusts headings so that none turns the long way round.
function withShortTurns(points) {
  let heading = points[0][3];
  return points.map(([x, y, z, next, look]) => {
    heading += shortTurn(heading, next);
    return [x, y, z, heading, look];
  });
}

// Turning 30 degrees counts as much as moving one unit.
function distance(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2], (a[3] - b[3]) / 30);
}

// The uniform Catmull-Rom spline (Catmull and Rom 1974) from b to c, `t` from 0 to 1.
function catmullRom(a, b, c, d, t) {
  return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

// A turn on the spot, for scenes without a flight.
export function roundAbout({ x, y, z, heading, look }) {
  const points = [0, 90, 180, 270].map((turn) => [x, y, z, heading + turn, look]);
  return { seconds: 30, points };
}
