// Helpers for what a <ray-caster> hands to pages: details of events, errors, promises.

import { withList } from '../engine/trouble.js';

// Turns the detail of the event `error` into an Error, whose message lists the faults too.
export function asError(detail) {
  return Object.assign(new Error(), detail, { message: withList(detail.message, detail.faults) });
}

// A pen acts as a finger does.
export function isFinger({ pointerType }) {
  return pointerType === 'touch' || pointerType === 'pen';
}

// Reads the engine's state only on demand, because the event comes with every picture.
export function frameDetail(engine) {
  return {
    get steps() {
      return engine.state.steps;
    },
  };
}

export function withResolvers() {
  const made = {};
  made.promise = new Promise((resolve, reject) => Object.assign(made, { resolve, reject }));
  made.promise.catch(() => {}); // without this, a promise that nobody awaits logs an error
  return made;
}
