// Whether the browser has read all of an element's children: where the element is defined early, it
// comes to life before they are there.
//
//     if (!hasParsed(element)) whenParsed(element, again, {signal});

export function hasParsed(element) {
  if (element.ownerDocument.readyState !== 'loading') return true;
  // What comes after it shows that its end tag has been read.
  for (let node = element; node !== null; node = node.parentNode ?? node.host ?? null) {
    if (node.nextSibling !== null && node.nextSibling !== undefined) return true;
  }
  return false;
}

export function whenParsed(element, act, { signal }) {
  element.ownerDocument.addEventListener('DOMContentLoaded', act, { once: true, signal });
}
