// What goes wrong in a reader's program, in plain words.
//
//     explain(error, text)       // { says, raw, line, column }; error: of runner.js
//     suspicions(text)           // [{ says, line, column }] that the program runs in spite of
//
// `raw` is the browser's message; line 0 means that the place is unknown. Messages are those of
// Chromium, Firefox and WebKit.

const kRules = [
  {
    when: /^(?:Can't find variable: )?([\w$]+)(?: is not defined)?$|^assignment to undeclared variable ([\w$]+)$/,
    only: /is not defined|find variable|undeclared/,
    says: ([, name, assigned], { text, line }) => notDefined(name ?? assigned, text, line),
  },
  {
    when: /Cannot access '([\w$]+)' before|can't access lexical declaration '([\w$]+)'|uninitialized variable/,
    says: ([, name, other]) =>
      `${quoted(name ?? other, 'A variable')} is used above the line that declares it.`,
  },
  {
    when: /Cannot (?:read|set) properties of (undefined|null)(?: \((?:reading|setting) '([^']+)'\))?/,
    says: ([, what, property]) => ofNothing(what, property),
  },
  {
    when: /Cannot destructure property '([^']+)' of '(.+?)' as it is (undefined|null)/,
    says: ([, property, owner, what]) => ofNothing(what, property, owner),
  },
  {
    when: /^(?:can't access property "([^"]+)", )?(.+?) is (undefined|null)(?: \(evaluating .*)?$/,
    says: ([, property, owner, what]) => ofNothing(what, property, owner),
  },
  {
    when: /(undefined|null) is not an object/,
    says: ([, what]) => ofNothing(what),
  },
  {
    when: /^(.+?) is not a function/,
    says: ([, name]) =>
      `\`${name}\` is called like a function, but it is something else. Is the name right?`,
  },
  {
    when: /is not iterable|is not a function or its return value is not iterable|not destructurable/,
    says: () =>
      'A list is taken apart here, but there is no list. Does the function that made it end with `return`?',
  },
  {
    when: /Assignment to constant|invalid assignment to const|readonly property/,
    says: () => 'A `const` gets another value. Declare it with `let` if it shall change.',
  },
  {
    when: /call stack|too much recursion/i,
    says: () => 'A function calls itself again and again, and never stops. What should end it?',
  },
  {
    when: /already been declared|redeclaration|duplicate variable/,
    says: () =>
      'The same name is declared twice. Rename one, or leave out the second `const` or `let`.',
  },
  {
    when: /Invalid array length|array length must be|array buffer allocation|invalid or out-of-range/i,
    says: () =>
      'A list is asked to be impossibly long. Is its length a whole number, and not `NaN`?',
  },
  {
    when: /Illegal return|return not in function|Return statements are only valid inside functions/,
    says: () => 'This `return` is outside of any function. Is there a `}` too many above it?',
  },
  {
    when: /Missing initializer|missing = in/,
    says: () => 'A `const` needs its value at once: `const name = value;`',
  },
  {
    when: /missing \) |Unexpected token '\)'|Expected '\)'|expected expression, got '\)'/i,
    says: () => 'The round brackets do not match: a `)` is missing, or there is one too many.',
  },
  {
    when: /Invalid left-hand side|invalid assignment left|Left side of assignment/,
    says: () => 'The left side of `=` cannot take a value. To compare, write `===`.',
  },
  {
    when: /Invalid or unexpected token|unterminated string|illegal character|Unexpected EOF in string/i,
    says: () =>
      'There is a character that JavaScript does not know here, or a text without its end.',
  },
];

export function explain(error, text) {
  const { kind, name, message, line, column } = error;
  const at = { line, column };
  if (kind === 'time')
    return {
      says:
        'Your program took more than 2 seconds, so it was stopped. Does a loop run forever? ' +
        'Look at what should end it, and whether that ever changes. The last picture stays.',
      raw: '',
      ...suspectLoop(text),
    };
  if (kind === 'frame')
    return {
      says: 'Your program used up all memory, so it was stopped. Does a list grow in a loop?',
      raw: '',
      ...suspectLoop(text),
    };

  const raw = `${name}: ${message}`;
  if (name === 'SyntaxError' || error.isEnd) {
    const brace = unmatched(text);
    if (brace !== null) return { ...brace, raw };
  }
  for (const { when, only, says } of kRules) {
    const match = when.exec(message);
    if (match !== null && (only === undefined || only.test(message)))
      return { says: says(match, { text, line }), raw, ...at };
  }
  if (name === 'SyntaxError')
    return { says: 'JavaScript cannot read this line, or the one above it.', raw, ...at };
  return { says: 'The program stops here.', raw, ...at };
}

export function suspicions(text) {
  const found = [];
  const code = withoutTexts(text);
  for (const { 1: keyword, 0: begin, index } of code.matchAll(/\b(if|while|for)\s*\(/g)) {
    const from = index + begin.length;
    const end = endOfBrackets(code, from);
    if (end < 0) continue;
    const single = /[^=!<>+\-*/%&|^]=(?![=>])/.exec(code.slice(from, end));
    if (keyword !== 'for' && single !== null)
      found.push({
        says: '`=` in a condition gives a value. To compare, write `===`.',
        ...placeOf(text, from + single.index + 1),
      });
    const isEndOfDo = keyword === 'while' && /\}\s*$/.test(code.slice(0, index));
    if (!isEndOfDo && /^\)\s*;/.test(code.slice(end)))
      found.push({
        says: 'The `;` ends this statement: what follows does not belong to it.',
        ...placeOf(text, code.indexOf(';', end)),
      });
  }
  return found;
}

// Where the round bracket closes that has been opened before `from`, or -1.
function endOfBrackets(code, from) {
  let depth = 1;
  for (let at = from; at < code.length; at++) {
    if (code[at] === '(') depth++;
    if (code[at] === ')' && --depth === 0) return at;
  }
  return -1;
}

function notDefined(name, text, line) {
  const known = new Set(
    [...withoutTexts(text).matchAll(/\b(?:function|const|let|class)\s+([\w$]+)/g)].map(
      ([, declared]) => declared,
    ),
  );
  for (const [, list] of withoutTexts(text).matchAll(/\b(?:const|let)\s+[[{]([^\]}=]*)[\]}]/g))
    for (const part of list.split(',')) known.add(part.split(':').at(-1).trim());
  for (const [, list] of withoutTexts(text).matchAll(/\bfunction\s+[\w$]+\s*\(([^)]*)\)/g))
    for (const part of list.split(',')) known.add(part.replace(/=.*/s, '').trim());
  if (known.has(name))
    return `There is a \`${name}\`, but not here: it belongs to another function or block.`;
  const similar = [...known].find((other) => distance(name, other) <= 1 + (name.length > 5));
  if (similar) return `There is no \`${name}\`. Did you mean \`${similar}\`?`;
  return `There is no \`${name}\`${line > 0 ? ' here' : ''}: nothing declares it.`;
}

function ofNothing(what, property, owner = undefined) {
  const whose = property === undefined ? 'Something' : `\`.${property}\``;
  const from =
    owner === undefined ? `something that is \`${what}\`` : `\`${owner}\`, which is \`${what}\``;
  return `${whose} is asked of ${from}. Is it outside the map or the list, or is a \`return\` missing?`;
}

// The bracket that has no partner, or null.
function unmatched(text) {
  const code = withoutTexts(text);
  const open = [];
  const kPairs = { '}': '{', ')': '(', ']': '[' };
  for (const { 0: bracket, index } of code.matchAll(/[{}()[\]]/g)) {
    if (!Object.hasOwn(kPairs, bracket)) {
      open.push({ bracket, index });
    } else if (open.at(-1)?.bracket === kPairs[bracket]) {
      open.pop();
    } else {
      return {
        says:
          open.length === 0
            ? `This \`${bracket}\` closes nothing.`
            : `This \`${bracket}\` does not match the \`${open.at(-1).bracket}\` of line ${placeOf(text, open.at(-1).index).line}.`,
        ...placeOf(text, index),
      };
    }
  }
  if (open.length === 0) return null;
  // The function that swallows the next one is the one whose end is missing.
  const inner = open.findLast(({ index }) => indentAt(text, index) === 0) ?? open[0];
  const after = open.find(({ index }) => index > inner.index);
  const { bracket, index } = after ?? inner;
  const closing = { '{': '}', '(': ')', '[': ']' }[bracket];
  return {
    says: `This \`${bracket}\` is never closed: a \`${closing}\` is missing.`,
    ...placeOf(text, index),
  };
}

function suspectLoop(text) {
  const code = withoutTexts(text);
  const match = /\bwhile\s*\(\s*(?:true|1)\s*\)|\bfor\s*\(\s*;\s*;\s*\)/.exec(code);
  return match === null ? { line: 0, column: 0 } : placeOf(text, match.index);
}

// Texts and comments become blanks, so that what is left is code at the same places.
function withoutTexts(text) {
  return text.replace(
    /\/\/[^\n]*|\/\*[\s\S]*?\*\/|'(?:\\.|[^'\\\n])*'|"(?:\\.|[^"\\\n])*"|`(?:\\.|[^`\\])*`/g,
    (part) => part.replace(/[^\n]/g, ' '),
  );
}

function placeOf(text, index) {
  const lines = text.slice(0, index).split('\n');
  return { line: lines.length, column: lines.at(-1).length + 1 };
}

function indentAt(text, index) {
  const start = text.lastIndexOf('\n', index) + 1;
  return /^\s*/.exec(text.slice(start))[0].length;
}

const quoted = (name, otherwise) => (name === undefined ? otherwise : `\`${name}\``);

// How many letters must change, go or come.
function distance(one, other) {
  let row = Array.from({ length: other.length + 1 }, (_, index) => index);
  for (let i = 1; i <= one.length; i++) {
    const next = [i];
    for (let j = 1; j <= other.length; j++)
      next.push(
        Math.min(row[j] + 1, next[j - 1] + 1, row[j - 1] + (one[i - 1] === other[j - 1] ? 0 : 1)),
      );
    row = next;
  }
  return row.at(-1);
}
