// The warnings of a <ray-caster>: bad values of attributes, which it ignores, and probable mistakes
// in its scene.
//
//     const warnings = new Warnings(({attribute, message}) => {...});
//     const warn = warnings.renew('options');       // forgets earlier warnings of this subject
//     warn('options', "Unknown option 'fvo'. Did you mean 'fov'?");
//     warnings.list
//
// A warning that was there before renew() and comes again is not reported again.

export class Warnings {
  #tell;
  #standing = new Map(); // subject -> [{attribute, message}]

  constructor(tell) {
    this.#tell = tell;
  }

  get list() {
    return [...this.#standing.values()].flat();
  }

  renew(subject) {
    const before = this.#standing.get(subject) ?? [];
    const now = [];
    this.#standing.set(subject, now);
    return (attribute, message) => {
      now.push({ attribute, message });
      if (!before.some((one) => one.attribute === attribute && one.message === message))
        this.#tell({ attribute, message });
    };
  }
}
