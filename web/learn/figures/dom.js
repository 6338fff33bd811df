// Puts markup of figures into a page without the browser's HTML parser, which a page's policy may
// forbid (require-trusted-types-for 'script').
//
//     putMarkup(node, '<p class="fig-title">The map</p><svg ...>...</svg>');
//
// Elements that are there already stay and are brought up to date, so that focus, scrolling and
// pointers are kept. It understands elements, attributes in double quotation marks, text, and what
// escape() writes.

const kParts = /<\/[\w-]+>|<([\w-]+)((?:\s+[\w:-]+="[^"]*")*)\s*(\/?)>|([^<]+)/g;
const kAttribute = /([\w:-]+)="([^"]*)"/g;
const kEmpty = ['br', 'input', 'img']; // without an end
const kEscapes = { '&amp;': '&', '&lt;': '<', '&gt;': '>', '&quot;': '"', '&nbsp;': '\u00a0' };
const kSpaces = { svg: 'http://www.w3.org/2000/svg', math: 'http://www.w3.org/1998/Math/MathML' };
const kHtml = 'http://www.w3.org/1999/xhtml';

export function putMarkup(node, markup) {
  // What has not ended yet, the innermost last; `next` is the child that comes next.
  const inside = [{ node, space: node.namespaceURI, next: node.firstChild }];
  for (const [, name, attributes, end, text] of markup.matchAll(kParts)) {
    const place = inside.at(-1);
    if (text !== undefined) putText(place, unescape(text));
    else if (name === undefined) close(inside.pop());
    else {
      const space =
        kSpaces[name] ?? (place.node.localName === 'foreignObject' ? kHtml : place.space);
      const element = putElement(place, name, space);
      putAttributes(element, attributes);
      const within = { node: element, space, next: element.firstChild };
      if (end !== '' || kEmpty.includes(name)) close(within);
      else inside.push(within);
    }
  }
  close(inside[0]);
}

function putText(place, content) {
  const { next } = place;
  if (next?.nodeType === 3) {
    if (next.data !== content) next.data = content;
    place.next = next.nextSibling;
  } else place.node.insertBefore(document.createTextNode(content), next);
}

function putElement(place, name, space) {
  const { next } = place;
  if (next?.localName === name && next.namespaceURI === space) {
    place.next = next.nextSibling;
    return next;
  }
  const element = document.createElementNS(space, name);
  if (next === null) place.node.append(element);
  else {
    // What stood here is of another kind: it is replaced.
    place.next = next.nextSibling;
    next.replaceWith(element);
  }
  return element;
}

function putAttributes(element, attributes) {
  const wanted = new Map();
  for (const [, name, value] of attributes.matchAll(kAttribute)) wanted.set(name, unescape(value));
  for (const { name } of [...element.attributes])
    if (!wanted.has(name)) element.removeAttribute(name);
  for (const [name, value] of wanted)
    if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}

// Removes the children that are left over.
function close({ next }) {
  while (next !== null) {
    const following = next.nextSibling;
    next.remove();
    next = following;
  }
}

function unescape(text) {
  return text.replace(/&\w+;/g, (code) => kEscapes[code] ?? code);
}
