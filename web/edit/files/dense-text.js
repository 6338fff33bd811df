// Bytes as printable letters that mean nothing to HTML: a page can hold them in a script element.
// Two letters hold 13 bits, so they take 23 % more room than the bytes; base64 takes 33 %.
//
//     const text = denseText(bytes);      // lines of 1,000 letters
//     const bytes = bytesOfDense(text);
//
// There are 91 letters: those of ASCII from '#' to '~' without '<'.

const kFirst = 35; // '#'
const kLeftOut = 60; // '<'
const kLetters = 91;
const kLine = 1000;

const letterOf = (value) => kFirst + value + (kFirst + value >= kLeftOut ? 1 : 0);
const valueOf = (code) => code - kFirst - (code > kLeftOut ? 1 : 0);

export function denseText(bytes) {
  const codes = new Uint8Array(Math.ceil((bytes.length * 8) / 13) * 2);
  let length = 0;
  let bits = 0;
  let count = 0;
  for (const byte of bytes) {
    bits |= byte << count;
    count += 8;
    if (count < 13) continue;
    const value = bits & 8191;
    codes[length++] = letterOf(value % kLetters);
    codes[length++] = letterOf(Math.floor(value / kLetters));
    bits >>= 13;
    count -= 13;
  }
  // A single last letter stands for up to six bits.
  if (count > 0) codes[length++] = letterOf(bits % kLetters);
  if (count > 6) codes[length++] = letterOf(Math.floor(bits / kLetters));
  const text = new TextDecoder().decode(codes.subarray(0, length));
  return text.replaceAll(new RegExp(`.{${kLine}}`, 'g'), '$&\n');
}

export function bytesOfDense(text) {
  const letters = text.replaceAll(/\s/g, '');
  const bytes = new Uint8Array(letters.length);
  let length = 0;
  let bits = 0;
  let count = 0;
  for (let at = 0; at < letters.length; at += 2) {
    const isPair = at + 1 < letters.length;
    const high = isPair ? valueOf(letters.charCodeAt(at + 1)) * kLetters : 0;
    bits |= (valueOf(letters.charCodeAt(at)) + high) << count;
    count += isPair ? 13 : 6;
    for (; count >= 8; count -= 8, bits >>= 8) bytes[length++] = bits & 255;
  }
  return bytes.subarray(0, length);
}
