// Edits of a JSON text that set one value and leave the rest to the letter.
//
//     const tree = parseTree(text);                            // of jsonc-parser
//     editsToSet(text, tree, ['start', 'x'], 2.5)              // [{offset, length, content}]
//     editsToSet(text, tree, ['start'], undefined)             // removes it, with its comma
//     editsToRemove(text, tree, ['maps'], [0, 2])               // members of a list
//     editsToSet(text, tree, ['maps', 1], map, {insert: true}) // before what stands there
//     editsToRename(tree, ['sprites', 'oak'], 'elm')           // the key alone
//     printed({ a: [1, 2] }, '  ')                             // as text, indented from there on
//
// Edits do not overlap and are in the order of the text. New values look like those around them.

import { findNodeAtLocation } from 'jsonc-parser';

const kMostColumns = 100; // of a value on one line
const kStep = '  ';

export function editsToSet(text, tree, path, value, { insert = false } = {}) {
  if (path.length === 0) return [{ ...rangeOf(tree), content: printed(value, '') }];
  const node = findNodeAtLocation(tree, path);
  if (value === undefined) return node === undefined ? [] : [removal(text, node)];
  if (node !== undefined && !insert)
    return [{ ...rangeOf(node), content: printed(value, indentAt(text, node.offset)) }];
  const parent = findNodeAtLocation(tree, path.slice(0, -1));
  const key = path.at(-1);
  if (parent === undefined || !(parent.type === 'object' || parent.type === 'array'))
    return editsToSet(
      text,
      tree,
      path.slice(0, -1),
      typeof key === 'number' ? [value] : { [key]: value },
    );
  return [insertion(text, parent, key, value)];
}

// From the first letter that differs to the last one.
export function editsToBecome(text, wanted) {
  if (text === wanted) return [];
  const most = Math.min(text.length, wanted.length);
  let begin = 0;
  while (begin < most && text[begin] === wanted[begin]) ++begin;
  let tail = 0;
  while (tail < most - begin && text.at(-1 - tail) === wanted.at(-1 - tail)) ++tail;
  return [
    {
      offset: begin,
      length: text.length - begin - tail,
      content: wanted.slice(begin, wanted.length - tail),
    },
  ];
}

// Removes members of a list, by their indexes in ascending order.
export function editsToRemove(text, tree, path, indexes) {
  const list = findNodeAtLocation(tree, path);
  const { children } = list;
  const gone = new Set(indexes);
  if (children.every((_, index) => gone.has(index)))
    return [{ offset: list.offset + 1, length: list.length - 2, content: '' }];
  const edits = [];
  children.forEach((child, index) => {
    if (!gone.has(index) || gone.has(index - 1)) return;
    let last = index;
    while (gone.has(last + 1)) last += 1;
    const from = index === 0 ? child.offset : endOf(children[index - 1]);
    const to = index === 0 ? children[last + 1].offset : endOf(children[last]);
    edits.push({ offset: from, length: to - from, content: '' });
  });
  return edits;
}

// Another key for what stands there.
export function editsToRename(tree, path, name) {
  const [key] = findNodeAtLocation(tree, path)?.parent?.children ?? [];
  return key?.type === 'string' ? [{ ...rangeOf(key), content: JSON.stringify(name) }] : [];
}

// On one line if it fits, else a member a line. Rows of tiles always stand below each other.
export function printed(value, indent, key = '') {
  const flat = flatText(value);
  const isContainer = typeof value === 'object' && value !== null;
  if (!isContainer || (indent.length + key.length + flat.length < kMostColumns && !hasRows(value)))
    return flat;
  const inner = indent + kStep;
  const [open, close] = Array.isArray(value) ? '[]' : '{}';
  const members = Array.isArray(value)
    ? value.map((member) => printed(member, inner))
    : Object.entries(value)
        .filter(([, member]) => member !== undefined)
        .map(([name, member]) => {
          const start = `${JSON.stringify(name)}: `;
          return start + printed(member, inner, start);
        });
  if (members.length === 0) return open + close;
  return `${open}\n${inner}${members.join(`,\n${inner}`)}\n${indent}${close}`;
}

function flatText(value) {
  if (Array.isArray(value)) return `[${value.map(flatText).join(', ')}]`;
  if (typeof value !== 'object' || value === null) return JSON.stringify(value);
  const members = Object.entries(value).filter(([, member]) => member !== undefined);
  if (members.length === 0) return '{}';
  return `{ ${members.map(([name, member]) => `${JSON.stringify(name)}: ${flatText(member)}`).join(', ')} }`;
}

function hasRows(value) {
  if (typeof value !== 'object' || value === null) return false;
  const members = Object.values(value);
  return (
    (Array.isArray(value) && members.length > 1 && isRow(members[0]) && members.every(isRow)) ||
    members.some(hasRows)
  );
}

const isRow = (value) => typeof value === 'string' && value.length > 1 && !/[a-z]{3}/i.test(value);

const rangeOf = ({ offset, length }) => ({ offset, length });
const endOf = ({ offset, length }) => offset + length;

// The blanks at the beginning of the line of a place.
function indentAt(text, offset) {
  const begin = text.lastIndexOf('\n', offset - 1) + 1;
  return /^[ \t]*/.exec(text.slice(begin, offset))[0];
}

// A member of an object with its key, or an element of an array.
function memberOf(node) {
  return node.parent.type === 'property' ? node.parent : node;
}

function removal(text, node) {
  const member = memberOf(node);
  const siblings = member.parent.children;
  const index = siblings.indexOf(member);
  const before = siblings[index - 1];
  const after = siblings[index + 1];
  if (before !== undefined)
    return { offset: endOf(before), length: endOf(member) - endOf(before), content: '' };
  if (after !== undefined)
    return { offset: member.offset, length: after.offset - member.offset, content: '' };
  const { offset, length } = member.parent;
  return { offset: offset + 1, length: length - 2, content: '' };
}

function insertion(text, parent, key, value) {
  const { children } = parent;
  const start = parent.type === 'object' ? `${JSON.stringify(key)}: ` : '';
  if (children.length === 0) {
    const whole = parent.type === 'object' ? { [key]: value } : [value];
    return { ...rangeOf(parent), content: printed(whole, indentAt(text, parent.offset)) };
  }
  const index = parent.type === 'array' ? Math.min(key, children.length) : children.length;
  const first = children[0];
  const gap = text.slice(parent.offset + 1, first.offset);
  const isBroken = gap.includes('\n');
  const indent = indentAt(text, isBroken ? first.offset : parent.offset);
  const content = start + printed(value, indent, start);
  const between = isBroken ? gap.slice(gap.lastIndexOf('\n')) : ' ';
  if (index === children.length)
    return { offset: endOf(children[index - 1]), length: 0, content: `,${between}${content}` };
  return { offset: children[index].offset, length: 0, content: `${content},${between}` };
}
