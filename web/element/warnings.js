// What a <ray-caster> warns of: what its attributes say that cannot be. The rest is drawn.
//
//     const warnings = new Warnings(({attribute, message}) => {...});      // hears of each once, as long as it stands
//     const warn = warnings.renew('options');       // what was said of these before is over
//     warn('options', "Unknown option 'fvo'. Did you mean 'fov'?");
//     warnings.list

export class Warnings {
  #tell;
  #standing = new Map(); // what they are about -> [{attribute, message}]

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
