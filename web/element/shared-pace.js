// All pictures of a page share one time budget: how long all of them draw in a frame sets the scale
// of those with size="auto". A picture at rest has scale 1: all pixels of its box. The scale does
// not change while isCounted() is true, because an overlay counts columns.
//
//     const pace = joinPace({ setScale(scale) {...}, isCounted: () => false });
//     pace.plays(true);                    // whether its world runs
//     pace.drew(time, milliseconds);       // when a frame began, and how long drawing took
//     pace.leave();

import { Pace } from './pace.js';

const kRest = 300; // milliseconds without a frame after which a picture is at rest
const kFlow = 100; // milliseconds from one picture to the next frame; frames this close flow
const kFlowing = 3; // flowing frames in a row after which a picture moves, though its world rests

const pace = new Pace();
const members = new Set();
let time = null; // of the current frame
let busy = 0; // milliseconds of drawing in it
let rest = 0; // the timer of findResting; 0 for none

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

// Whether the picture may come to rest without further news, so that a timer must look.
const needsRest = (member) => !member.plays && (moves(member) || member.scale !== 1);

// Ends the previous frame, of which all pictures have been drawn, and begins another one.
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
