// Makes the states of the reader's raycaster out of the text of raycaster.txt, whose first lines
// explain the directives.

const kChapters = 22;

const kNever = { first: 0, last: 0 };

// The top-level functions of a program: [{ name, text, line }]. Comments right above a function
// belong to it; `line` is that of the word "function", from 1.
export function functionsOf(text) {
  const lines = text.split('\n');
  const found = [];
  lines.forEach((line, index) => {
    const name = /^(?:async )?function\s*\*?\s*([\w$]+)/.exec(line)?.[1];
    if (!name) return;
    let first = index;
    while (first > 0 && lines[first - 1].startsWith('//')) first--;
    let last = index;
    if (!line.trimEnd().endsWith('}'))
      while (last < lines.length - 1 && !lines[last].startsWith('}')) last++;
    found.push({ name, text: lines.slice(first, last + 1).join('\n'), line: index + 1 });
  });
  return found;
}

// For `new Function(asBody(text))()`, which returns the program's functions.
export function asBody(text) {
  return `${text}\nreturn { ${namesIn(text).join(', ')} };\n`;
}

// For a module, which exports them.
export function asModule(text) {
  return `${text}\nexport { ${namesIn(text).join(', ')} };\n`;
}

function namesIn(text) {
  return [...new Set(functionsOf(text).map(({ name }) => name))];
}

// The scene of a chapter, in web/learn/scenes.
export function sceneOf(chapter) {
  if (chapter === 22) return 'corner.json';
  if (chapter >= 19) return 'yard.json';
  return `yard-${chapter < 12 ? 1 : chapter < 14 ? 2 : chapter - 11}.json`;
}

// The engine's options with which it draws only what was taught by a chapter.
export function engineOptions(chapter) {
  return {
    textures: chapter >= 6,
    detail: chapter >= 7,
    light: chapter >= 10,
    fog: chapter >= 10,
  };
}

export function makeStates(source) {
  const { lines, starts, kept, hints } = read(source);

  function answer(chapter) {
    mustBeChapter(chapter);
    return lines
      .filter(({ first, last }) => chapter >= first && chapter <= last)
      .map(({ text }) => text)
      .join('\n')
      .replace(/\n{3,}/g, '\n\n')
      .trim()
      .concat('\n');
  }

  // The answer, with the functions that are the reader's to mend instead of those that it has.
  function start(chapter) {
    let text = answer(chapter);
    const instead = functionsOf((starts.get(chapter) ?? []).join('\n'));
    for (const name of kept.get(chapter) ?? []) {
      const before = functionsOf(answer(chapter - 1)).find((each) => each.name === name);
      const mend = `// Yours to mend: this is how the last chapter left it.\n`;
      instead.push({ name, text: mend + before.text });
    }
    for (const { name, text: mended } of instead) {
      const own = functionsOf(text).find((each) => each.name === name);
      text = text.replace(own.text, () => mended);
    }
    return text;
  }

  function functionText(chapter, name) {
    const found = functionsOf(answer(chapter)).find((each) => each.name === name);
    if (!found) throw new Error(`Chapter ${chapter} has no function ${name}.`);
    return found.text;
  }

  // The functions that are new or changed in a chapter, with hints in three steps.
  function newIn(chapter) {
    const before = new Map(
      chapter === 1 ? [] : functionsOf(answer(chapter - 1)).map(({ name, text }) => [name, text]),
    );
    const now = functionsOf(answer(chapter));
    const mended = new Set([
      ...functionsOf((starts.get(chapter) ?? []).join('\n')).map(({ name }) => name),
      ...(kept.get(chapter) ?? []),
    ]);
    const place = new Map(functionsOf(start(chapter)).map(({ name, line }) => [name, line]));
    return now
      .filter(({ name, text }) => before.get(name) !== text || mended.has(name))
      .map(({ name, text }) => ({
        name,
        isNew: !before.has(name),
        isYours: mended.has(name),
        where: `In \`${name}\`, line ${place.get(name)}.`,
        what: hints.get(`${chapter} ${name}`) ?? firstComment(text),
        lines: text,
      }));
  }

  return {
    chapters: kChapters,
    answer,
    start,
    functionText,
    newIn,
    names: (chapter) => namesIn(answer(chapter)),
    lines: (chapter) =>
      answer(chapter)
        .split('\n')
        .filter((line) => line.trim() !== '' && !line.trim().startsWith('//')).length,
  };
}

function mustBeChapter(chapter) {
  if (!Number.isInteger(chapter) || chapter < 1 || chapter > kChapters)
    throw new RangeError(`chapter: found ${chapter}, expected a whole number from 1 to 22`);
}

function firstComment(text) {
  const comment = text.split('\n').filter((line) => line.startsWith('// '));
  return comment.map((line) => line.slice(3)).join(' ');
}

// The lines with their chapters, the functions at the starts, and the hints.
function read(source) {
  const lines = [];
  const starts = new Map();
  const kept = new Map();
  const hints = new Map();
  let range = kNever;
  let startOf = 0;
  for (const text of source.split('\n')) {
    if (!text.startsWith('//#')) {
      if (startOf > 0) starts.get(startOf).push(text);
      else if (range !== kNever) lines.push({ ...range, text });
      continue;
    }
    const words = text.slice(3).trim();
    const [, keep] = /^keep (.*)$/.exec(words) ?? [];
    const [, hint] = /^hint (.*)$/.exec(words) ?? [];
    const [, begin] = /^start (\d+)$/.exec(words) ?? [];
    if (keep) {
      const [chapter, ...names] = keep.split(' ');
      kept.set(Number(chapter), names);
    } else if (hint) {
      const [, key, what] = /^(\d+ \w+): (.*)$/.exec(hint);
      hints.set(key, hints.has(key) ? `${hints.get(key)} ${what}` : what);
    } else if (begin) {
      startOf = Number(begin);
      starts.set(startOf, []);
    } else {
      startOf = 0;
      range = readRange(words, text);
    }
  }
  return { lines, starts, kept, hints };
}

function readRange(words, text) {
  if (words === '') return { first: 1, last: kChapters };
  const [, first, dots, last] = /^(\d+)(\.\.)?(\d*)$/.exec(words) ?? [];
  if (!first) throw new Error(`raycaster.txt: found the directive ${text}`);
  return { first: Number(first), last: Number(last || (dots ? kChapters : first)) };
}
