// The pictures of a page share one budget: what all of them take in a frame decides the scale of
// those whose size follows their boxes. A picture that stands still has all the pixels of its box,
// and the size stays as it is while somebody counts the columns.
//
//     const pace = joinPace({ setScale(scale) {...}, isCounted: () => false });
//     pace.plays(true);                    its world goes on; or false
//     pace.drew(time, milliseconds);       a frame that began then, and how long it took
//     pace.leave();

import { Pace } from './pace.js';

const kRest = 300; // milliseconds without a frame, after which a picture stands still
const kFlow = 100; // from frame to frame of a picture that moves, beside the time of drawing it
const kFlowing = 3; // such frames in a row

const pace = new Pace();
const members = new Set();
let time = null; // of the frame that is being drawn
let busy = 0; // in it, milliseconds
let rest = 0; // a timer, while something moves that does not play

export function joinPace({ setScale, isCounted }) {
  const member = { setScale, isCounted, scale: 1, plays: false, last: -Infinity, frames: 0 };
  members.add(member);
  pace.renew();
  return {
    plays(plays) {
      if (member.plays === plays) return;
      Object.assign(member, { plays, frames: 0 });
      if (![...members].some(moves)) pace.rest();
      apply(member);
    },
    drew(begin, milliseconds) {
      if (begin !== time) endFrame(begin);
      busy += milliseconds;
      member.frames = begin - member.last < kFlow ? member.frames + 1 : 0;
      member.last = begin + milliseconds;
      if (needsRest(member)) rest ||= setTimeout(findResting, kRest);
    },
    leave() {
      members.delete(member);
      pace.renew();
    },
  };
}

const moves = ({ plays, frames }) => plays || frames >= kFlowing;

// It may come to rest without anybody saying so.
const needsRest = (member) => !member.plays && (moves(member) || member.scale !== 1);

// The pictures of the frame before this one are all drawn.
function endFrame(begin) {
  if (time !== null && [...members].some(moves)) {
    pace.frame(time, busy);
    for (const member of members) apply(member);
  }
  time = begin;
  busy = 0;
}

function apply(member) {
  const scale = moves(member) ? pace.scale : 1;
  if (member.scale === scale || member.isCounted()) return;
  member.scale = scale;
  member.setScale(scale);
}

function findResting() {
  rest = 0;
  const now = performance.now();
  for (const member of members) {
    if (!needsRest(member)) continue;
    if (now - member.last < kRest) {
      rest ||= setTimeout(findResting, kRest);
    } else {
      member.frames = 0;
      apply(member);
    }
  }
}
