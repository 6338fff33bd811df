// Chooses the characters of a legend: letters of the name if they are free, then other letters,
// digits and signs, then Chinese characters, of which there are enough.
//
//     const legend = startLegend({ '#': 'wall' }, {});     // what it holds; what it must not use
//     legend.add('brick', 'brick');                    // 'b'; the same meaning has one character
//     legend.table                                     // { '#': 'wall', b: 'brick' }

// Without `"` and `\`, which JSON would escape, and what means nothing or is empty: `.` and blank.
const kLetters = 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ';
const kOthers = "0123456789+-*/=~^<>|_:;,!?%&$@()[]{}'`#";
const kFirstOfMany = 0x4e00; // 20,992 characters follow, each one code point

export function startLegend(table = {}, taken = {}) {
  const own = { ...table };
  const byMeaning = new Map(Object.entries(own).map(([sign, meaning]) => [meaning, sign]));
  const free = [...kLetters, ...kOthers].values();
  let many = kFirstOfMany;
  const isFree = (sign) => !Object.hasOwn(own, sign) && !Object.hasOwn(taken, sign);

  function next() {
    for (const sign of free) if (isFree(sign)) return sign;
    for (; ; ++many) {
      const sign = String.fromCodePoint(many);
      if (isFree(sign)) return sign;
    }
  }

  return {
    table: own,
    add(meaning, name, preferred = []) {
      if (byMeaning.has(meaning)) return byMeaning.get(meaning);
      const letters = [...name.slice(0, 20)].filter((letter) => kLetters.includes(letter));
      const [first = ''] = letters;
      const wishes = [...preferred, first.toLowerCase(), first.toUpperCase()];
      const sign = wishes.find((wish) => wish !== '' && isFree(wish)) ?? next();
      own[sign] = meaning;
      byMeaning.set(meaning, sign);
      return sign;
    },
  };
}
