// Programs as they stand in the page before the editor has loaded, and beside it.
//
//     paint(element, text)                 // coloured text
//     paint(element, text, isNew)          // lines for which isNew(index) is true are marked
//     newLines(before, after)              // Set of the indices of lines of `after` that are new

const kParts =
  /(?<comment>\/\/[^\n]*|\/\*[\s\S]*?\*\/)|(?<string>'(?:\\.|[^'\\\n])*'|"(?:\\.|[^"\\\n])*"|`(?:\\.|[^`\\])*`)|(?<number>\b\d[\w.]*)|(?<keyword>\b(?:break|case|const|continue|do|else|export|for|function|if|in|let|new|of|return|switch|throw|while)\b)/g;

export function paint(element, text, isNew = () => false) {
  const lines = [document.createDocumentFragment()];
  const add = (part, kind) =>
    part.split('\n').forEach((piece, index) => {
      if (index > 0) lines.push(document.createDocumentFragment());
      if (kind === undefined) return lines.at(-1).append(piece);
      const span = document.createElement('span');
      span.className = `tok-${kind}`;
      span.textContent = piece;
      return lines.at(-1).append(span);
    });
  let at = 0;
  for (const match of text.matchAll(kParts)) {
    add(text.slice(at, match.index));
    const [kind] = Object.entries(match.groups).find(([, part]) => part !== undefined);
    add(match[0], kind);
    at = match.index + match[0].length;
  }
  add(text.slice(at));
  element.replaceChildren(
    ...lines.flatMap((line, index) => {
      if (!isNew(index)) return [line, '\n'];
      const mark = document.createElement('mark');
      mark.className = 'new';
      mark.append(line);
      return [mark, '\n'];
    }),
  );
}

// All but the longest common subsequence of lines.
export function newLines(before, after) {
  const [old, now] = [before, after].map((text) => text.split('\n').map((line) => line.trim()));
  const length = Array.from({ length: old.length + 1 }, () => new Uint16Array(now.length + 1));
  for (let i = old.length - 1; i >= 0; i--)
    for (let j = now.length - 1; j >= 0; j--)
      length[i][j] =
        old[i] === now[j] ? length[i + 1][j + 1] + 1 : Math.max(length[i + 1][j], length[i][j + 1]);
  const found = new Set();
  let i = 0;
  for (let j = 0; j < now.length; j++) {
    while (i < old.length && old[i] !== now[j] && length[i + 1][j] >= length[i][j + 1]) i++;
    if (i < old.length && old[i] === now[j]) i++;
    else if (now[j] !== '') found.add(j);
  }
  return found;
}
