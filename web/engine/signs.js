// Splits a text into signs: what people see as one character. Most are one code point. Accents,
// shades, keycaps and the like belong to the code point before them, a flag is two regional
// letters, and a joiner (U+200D) takes a symbol behind it. The engine has the same rule: takeSign
// in src/scene/source_text.h.
//
//     signsOf('#❤️.')          ['#', '❤️', '.']

/* eslint-disable no-misleading-character-class -- the class is of joining characters */
const kSign =
  /(?:[\u{1f1e6}-\u{1f1ff}]{2}|[^])(?:\u200d[\u2100-\u{1ffff}]?|[\u0300-\u036f\u0483-\u0489\u1ab0-\u1aff\u1dc0-\u1dff\u20d0-\u20ff\u3099\u309a\ufe00-\ufe0f\ufe20-\ufe2f\u{1f3fb}-\u{1f3ff}\u{e0000}-\u{e0fff}]){0,15}/gu;

const kPlain = /^[ -~]*$/; // where each character is a sign

export function signsOf(text) {
  return kPlain.test(text) ? text.split('') : (text.match(kSign) ?? []);
}
