// Whose scene it is. What the page's owner allows from elsewhere was written by others: its title
// stands between quotation marks, behind the host that it comes from, so that it poses as nothing of
// the page's own, however long it is.
//
//     document.title = `${titleFrom(caster.address, title)} · Slicecast`;      // From worlds.example: “A garden”
//     hostOf(address)                                                          // 'worlds.example'; '' for one of the page's own

// What has no address is the page's or the visitor's. One that cannot be read is none of others'; the
// element says what is wrong with it.
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
  return host === '' ? title : `From ${host}: “${plain(title)}”`;
}

// The screen reader's name of the element, in the same words. The page's own need none.
export function nameFrom(address, title) {
  const name = titleFrom(address, title);
  return name === title ? null : name;
}

// Without what ends a quotation, or turns the direction of what follows.
function plain(title) {
  return title
    .replace(/["“”„‟]/g, '')
    .replace(/[\s\p{C}]+/gu, ' ')
    .trim();
}
