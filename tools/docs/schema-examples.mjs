// Finds an example value for each key of the scenes' JSON Schema, from scenes that use it.
//
//     keyExamples(schema, scenes, others)       // Map: 'gate.seconds' -> '1.2'
//
// `others` provides keys that no scene has. Short values that differ from the default are
// preferred.

const kLongest = 44; // characters; if all values are longer, the shortest is cut

export function keyExamples(schema, scenes, others) {
  let found; // 'kind.key' -> [{text, isDefault}]

  const follow = (raw, id) => {
    const target = raw.$ref ?? raw.allOf?.[0].$ref;
    if (target === undefined) return [raw, id];
    const name = target.split('/').at(-1);
    return follow(schema.definitions[name], name);
  };

  function visit(node, nodeId, value) {
    const [raw, id] = follow(node, nodeId);
    if (Array.isArray(value)) {
      const list = [raw, ...(raw.anyOf ?? [])].find(({ items }) => items);
      if (list) for (const each of value) visit(list.items, id, each);
      return;
    }
    if (typeof value !== 'object' || value === null) return;
    const variants = [[raw, id], ...(raw.anyOf ?? []).map((each) => follow(each, id))];
    const keyed = variants.filter(([{ properties }]) => properties);
    const named = variants
      .map(([each]) => each)
      .find(({ additionalProperties: each }) => typeof each === 'object');
    if (keyed.length === 0) {
      if (named)
        for (const each of Object.values(value)) visit(named.additionalProperties, id, each);
      return;
    }
    for (const [name, each] of Object.entries(value)) {
      const has = ([{ properties }]) => Object.hasOwn(properties, name);
      const hasAll = ([{ properties }]) =>
        Object.keys(value).every((key) => Object.hasOwn(properties, key));
      const [kind, own] = keyed.find(hasAll) ?? keyed.find(has) ?? [];
      const property = kind?.properties[name];
      if (property === undefined) continue;
      // A definition of its own has a table of its own, too.
      for (const table of new Set([id, own]))
        note(`${table}.${name}`, each, property.default ?? follow(property, name)[0].default);
      visit(property, name, each);
    }
  }

  function note(key, value, standard) {
    const text = JSON.stringify(withoutComments(value)).replaceAll(/([,:])(?=["\d[{-])/g, '$1 ');
    const all = found.get(key) ?? [];
    all.push({ text, isDefault: JSON.stringify(value) === JSON.stringify(standard) });
    found.set(key, all);
  }

  const examplesIn = (list) => {
    found = new Map();
    for (const scene of list) visit(schema, 'scene', scene);
    return [...found].map(([key, all]) => [key, best(all)]);
  };
  return new Map([...examplesIn(others), ...examplesIn(scenes)]);
}

function withoutComments(value) {
  return JSON.parse(JSON.stringify(value, (key, each) => (key === 'comment' ? undefined : each)));
}

function best(all) {
  const unusual = all.filter(({ isDefault }) => !isDefault);
  const texts = (unusual.length > 0 ? unusual : all).map(({ text }) => text);
  const short = texts.find((text) => text.length <= kLongest && text.length > 2);
  const shortest =
    short ?? texts.reduce((left, right) => (right.length < left.length ? right : left));
  return shortest.length <= kLongest ? shortest : `${shortest.slice(0, kLongest)} …`;
}
