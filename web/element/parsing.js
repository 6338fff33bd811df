// Whether the browser has parsed all of an element's children. If the element is defined early, it
// connects before they exist.
//
//     if (!hasParsed(element)) whenParsed(element, again, {signal});

export function hasParsed(element) {
  if (element.ownerDocument.readyState !== 'loading') return true;
  // A node after it shows that its end tag has been parsed.
  for (let node = element; node !== null; node = node.parentNode ?? node.host ?? null) {
    if (node.nextSibling !== null && node.nextSibling !== undefined) return true;
  }
  return false;
}

export function whenParsed(element, act, { signal }) {
  element.ownerDocument.addEventListener('DOMContentLoaded', act, { once: true, signal });
}
