// Reads the schema of scenes for forms: what a value may be, without references.
// Takes the schema; gives plain descriptions. Knows no document and no page.
//
//     const schema = new Schema(json);
//     schema.at(['maps', 0, 'fog', 'end'])     // of that value, see below
//     schema.of(node)                          // the same for a part of the schema
//     schema.sample(node, names)               // a value that it accepts
//
//     { title, about, fallback, kinds: [kind, ...] }     // `fallback` counts if it is left out
//
// A kind is one of the forms that a value may have:
//
//     { type: 'number' | 'integer', least, most }      { type: 'boolean' }
//     { type: 'text', pattern, choices, names,         // `names`: 'textures' if it is one of those
//       isColour, isLong }                             // `isLong`: of several lines
//     { type: 'list', item }                           // `item` is a part of the schema
//     { type: 'object', keys: Map, needed: [...], rest }   // of keys with any name: `rest`;
//                                                      // `always`: needed whatever else is said

// What keys, and definitions of the schema, name
const kNamesOf = new Map([
  ['textureName', 'textures'],
  ['sprite', 'sprites'],
  ['walk', 'sprites'],
  ['alert', 'sprites'],
  ['motion', 'motions'],
  ['map', 'maps'],
  ['follows', 'gates'],
  ['needs', 'finds'],
]);

const kLong = 200; // characters that a text may have

export class Schema {
  #root;

  constructor(root) {
    this.#root = root;
  }

  // Undefined for a key that there is not.
  at(path) {
    let node = this.#root;
    for (const key of path) {
      const { kinds } = this.of(node);
      const kind = kinds.find(({ type }) =>
        typeof key === 'number' ? type === 'list' : type === 'object',
      );
      if (kind === undefined) return undefined;
      node = typeof key === 'number' ? kind.item : this.#keyOf(kinds, key);
      if (node === undefined) return undefined;
    }
    return this.of(node, String(path.at(-1) ?? ''));
  }

  of(node, key = '') {
    const whole = this.#whole(node);
    const kinds = [];
    this.#collect(whole, key, kinds);
    return {
      title: whole.title ?? key,
      about: whole.description ?? '',
      fallback: whole.default,
      kinds,
    };
  }

  sample(node, names, key = '') {
    const { fallback, kinds } = this.of(node, key);
    const [kind] = kinds;
    if (fallback !== undefined && !(typeof fallback === 'object')) return fallback;
    switch (kind?.type) {
      case 'number':
      case 'integer':
        return Math.min(kind.most, Math.max(1, kind.least));
      case 'boolean':
        return true;
      case 'list':
        return Array.from({ length: kind.count }, () => this.sample(kind.item, names));
      case 'object':
        return Object.fromEntries(
          kind.needed.map((name) => [name, this.sample(kind.keys.get(name), names, name)]),
        );
      default:
        if (kind?.choices) return kind.choices[0];
        if (kind?.names) return names(kind.names)[0] ?? '';
        if (kind?.pattern?.includes('png')) return 'picture.png';
        return kind?.isColour ? '#808080' : 'something';
    }
  }

  #keyOf(kinds, key) {
    for (const kind of kinds) {
      if (kind.type !== 'object') continue;
      const found = kind.keys.get(key) ?? kind.rest;
      if (found !== undefined) return found;
    }
    return undefined;
  }

  // Without references and single parts of "allOf"; the outer words count.
  #whole(node) {
    let { $ref: reference, allOf, ...own } = node;
    if (reference !== undefined) {
      const name = reference.split('/').at(-1);
      own = { ...this.#whole(this.#root.definitions[name]), ...own };
      if (kNamesOf.has(name)) own.names = kNamesOf.get(name);
    }
    if (allOf?.length === 1) own = { ...this.#whole(allOf[0]), ...own };
    return own;
  }

  #collect(node, key, kinds) {
    const parts = node.type === undefined && node.enum === undefined ? node.anyOf : undefined;
    if (parts !== undefined) {
      for (const part of parts) this.#collect(this.#whole(part), key, kinds);
      return;
    }
    const { type, enum: choices, minimum, exclusiveMinimum, maximum } = node;
    if (choices?.every((choice) => typeof choice === 'number'))
      kinds.push({
        type: 'number',
        least: Math.min(...choices),
        most: Math.max(...choices),
        choices,
      });
    else if (type === 'number' || type === 'integer')
      kinds.push({
        type,
        least: minimum ?? exclusiveMinimum ?? -Infinity,
        most: maximum ?? Infinity,
      });
    else if (type === 'boolean') kinds.push({ type });
    else if (type === 'array')
      kinds.push({
        type: 'list',
        item: node.contains ? { ...node.items, ...node.contains } : node.items,
        count: node.minItems ?? (node.contains ? 1 : 0),
      });
    else if (type === 'object')
      kinds.push({
        type,
        keys: new Map(Object.entries(node.properties ?? {})),
        needed: [...(node.required ?? []), ...(node.else?.required ?? [])],
        always: node.required ?? [],
        rest: typeof node.additionalProperties === 'object' ? node.additionalProperties : undefined,
      });
    else
      kinds.push({
        type: 'text',
        pattern: node.pattern,
        choices,
        isColour: node.pattern === '^#[0-9a-fA-F]{6}$',
        isLong: type === 'string' && !node.pattern && (node.maxLength ?? Infinity) >= kLong,
        names: node.names ?? kNamesOf.get(key),
      });
  }
}

// Which of the kinds a value has.
export function kindOfValue(kinds, value) {
  const type = Array.isArray(value)
    ? 'list'
    : { number: 'number', boolean: 'boolean', string: 'text', object: 'object' }[typeof value];
  const fits = kinds.filter(
    (kind) => kind.type === type || (type === 'number' && kind.type === 'integer'),
  );
  if (type !== 'object') return fits[0];
  // Of several objects, that which knows all keys.
  return (
    fits.find(({ keys, rest }) => rest || Object.keys(value).every((key) => keys.has(key))) ??
    fits[0]
  );
}
