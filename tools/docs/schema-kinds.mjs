// Lists the kinds of objects in the scenes' JSON Schema with their keys, in the order in which a
// scene refers to them.
//
//     objectKinds(schema)       // [{id, title, description, nodes, keys}]
//     keys                      // [{name, node, required, description, standard}]
//
// A node is a part of the schema with references resolved: {type, enum, minimum, ..., items,
// values, variants, said}. The same part of the schema is always the same node.

// What the reference says of a value, in HTML, instead of its parts in the schema.
const kSaid = {
  colour: 'a colour, <code>#rrggbb</code>',
  file: 'a PNG file',
  textureName: 'the name of a texture',
  rows: 'rows of characters',
  legend: 'a name for each character',
  data: 'any JSON',
  groundName: '<code>floor</code> or the name of a blueprint',
};
// Better titles than the schema's, which need their context.
const kTitles = {
  scene: 'Scene',
  texture: 'Texture',
  sprite: 'Sheet of a sprite',
  to: 'Exit of a portal',
  objectMotion: 'Motion of an object',
  motion: 'Motion of blocks',
  sown: 'Sown objects',
  face: 'Face',
  water: 'Water',
};

export function objectKinds(schema) {
  const kinds = [];
  const nodes = new Map(); // part of the schema -> its node
  const wholes = new Map(); // kind -> what its objects are variants of
  const variants = new Map(); // part of the schema -> what it is a variant of

  // The node of a part. `id` is the key or the definition by which the schema names it.
  function nodeAt(raw, id) {
    if (nodes.has(raw)) return nodes.get(raw);
    const node = { ...raw };
    nodes.set(raw, node);
    const target = raw.$ref ?? raw.allOf?.[0].$ref;
    if (target !== undefined) {
      const name = target.split('/').at(-1);
      const followed = nodeAt(schema.definitions[name], name);
      return nodes.set(raw, followed).get(raw);
    }
    if (kSaid[id] !== undefined && !raw.additionalProperties?.$ref) node.said = kSaid[id];
    else if (raw.anyOf && !raw.properties) {
      for (const each of raw.anyOf) variants.set(each, raw);
      node.variants = raw.anyOf.map((each) => nodeAt(each, id));
    } else if (raw.properties) addKeys(node, raw, id);
    else if (raw.items) node.items = nodeAt(raw.items, id);
    else if (typeof raw.additionalProperties === 'object')
      node.values = nodeAt(raw.additionalProperties, id);
    return node;
  }

  // Adds an object's keys to its kind. Variants of one thing, such as a sky of two colours and a
  // panorama, are one kind.
  function addKeys(node, raw, id) {
    let kind = kinds.find((each) => each.id === id);
    if (kind === undefined) {
      const { title, description } = schema.definitions[id] ?? (id === 'scene' ? schema : raw);
      kind = { id, title: kTitles[id] ?? title, description, nodes: [], keys: [] };
      kinds.push(kind);
      wholes.set(kind, variants.get(raw));
    } else if (wholes.get(kind) === undefined || wholes.get(kind) !== variants.get(raw)) {
      throw new Error(`the schema has two different objects named "${id}"; one needs a definition`);
    }
    kind.nodes.push(node);
    for (const [name, value] of Object.entries(raw.properties)) {
      if (kind.keys.some((key) => key.name === name)) continue;
      const target = targetOf(schema, value);
      const key = {
        name,
        required: raw.required?.includes(name) ?? false,
        description: value.description ?? target.description ?? target.title ?? value.title,
        standard: value.default ?? target.default,
      };
      kind.keys.push(key);
      kind.title ??= titleOf(schema, id);
      key.node = nodeAt(value, name);
    }
  }

  nodeAt(schema, 'scene');
  for (const kind of kinds) {
    const { title, description } = describedAt(schema, kind.id);
    kind.title ??= title;
    kind.description ??= description;
  }
  return kinds;
}

function targetOf(schema, value) {
  const target = value.$ref ?? value.allOf?.[0].$ref;
  return target === undefined ? value : schema.definitions[target.split('/').at(-1)];
}

function titleOf(schema, id) {
  return describedAt(schema, id).title;
}

// Title and description of an object that is defined inside another one: those of its key there.
function describedAt(schema, id) {
  for (const { properties } of [schema, ...Object.values(schema.definitions)]) {
    const found = properties?.[id];
    if (found !== undefined) return { ...targetOf(schema, found), ...found };
  }
  return {};
}
