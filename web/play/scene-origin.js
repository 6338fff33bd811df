// Marks scenes from other origins and from links. Strangers may have written them, so their titles
// are quoted and follow the host's name; thus no title can pose as the page's own text.
//
//     quoted(title)                             // “A garden”
//     titleFrom(caster.address, title)      // From worlds.example: “A garden”
//     hostOf(address)                       // 'worlds.example'; '' for a scene of the page's own

// Scenes without an address are the page's or the visitor's. The element reports malformed ones.
export function hostOf(address) {
  try {
    const { origin, host } = new URL(address, document.baseURI);
    return origin === location.origin ? '' : host || 'elsewhere';
  } catch {
    return '';
  }
}

export function titleFrom(address, title) {
  const host = hostOf(address);
  return host === '' ? title : `From ${host}: ${quoted(title)}`;
}

// The element's label for screen readers, in the same words; null for the page's own scenes.
export function nameFrom(address, title) {
  const name = titleFrom(address, title);
  return name === title ? null : name;
}

// Without characters that end a quotation or change the direction of text.
export function quoted(title) {
  const plain = title
    .replace(/["“”„‟]/g, '')
    .replace(/[\s\p{C}]+/gu, ' ')
    .trim();
  return `“${plain}”`;
}
