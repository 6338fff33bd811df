// Turns markup of figures and table rows into elements without the browser's HTML parser, which a
// page's policy may forbid (require-trusted-types-for 'script').
//
//     putMarkup(svg, '<path d="M0 0h9" class="axis"/><text x="4" y="9">4 &lt; 9</text>');
//
// It replaces the element's content. It understands elements, attributes in double quotation marks,
// text, and what escape() writes.

const kParts = /<\/[\w-]+>|<([\w-]+)((?:\s+[\w-]+="[^"]*")*)\s*(\/?)>|([^<]+)/g;
const kAttribute = /([\w-]+)="([^"]*)"/g;
const kEmpty = ['br']; // without an end
const kEscapes = { '&amp;': '&', '&lt;': '<', '&quot;': '"' };

export function escape(text) {
  return String(text).replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/"/g, '&quot;');
}

export function putMarkup(node, markup) {
  const top = document.createDocumentFragment();
  const inside = [top]; // what has not ended yet, the innermost last
  for (const [, name, attributes, end, text] of markup.matchAll(kParts)) {
    if (text !== undefined) inside.at(-1).append(unescape(text));
    else if (name === undefined) inside.pop();
    else {
      const element = document.createElementNS(node.namespaceURI, name);
      for (const [, key, value] of attributes.matchAll(kAttribute))
        element.setAttribute(key, unescape(value));
      inside.at(-1).append(element);
      if (end === '' && !kEmpty.includes(name)) inside.push(element);
    }
  }
  node.replaceChildren(top);
}

function unescape(text) {
  return text.replace(/&\w+;/g, (code) => kEscapes[code] ?? code);
}
