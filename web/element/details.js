// Small things that go out of a <ray-caster>: details of events, errors, promises.

// What the event error carries, as something to throw.
export function asError(detail) {
  return Object.assign(new Error(detail.message), detail);
}

// Asked for only when somebody reads it: pictures come often.
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
  made.promise.catch(() => {}); // whoever waits hears of it
  return made;
}
