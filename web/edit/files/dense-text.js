// Bytes as letters that mean nothing to HTML: a page can hold them in a script element. A page of
// UTF-16 has 16 bits for each letter, and 15 of them are bits of the bytes.
//
//     const text = denseText(bytes);
//     const bytes = bytesOfDense(text);
//     const file = utf16(page);            // its mark at the beginning counts more than what a
//                                          // server says of the encoding
//
// The letters are U+4000 to U+BFFF, of East Asian scripts; the last one says how many bits of the
// one before it are none of the bytes'.

const kFirst = 0x4000;
const kBits = 15;
const kByteOrderMark = 0xfeff;

export function denseText(bytes) {
  const codes = new Uint16Array(Math.ceil((bytes.length * 8) / kBits) + 1);
  let length = 0;
  let bits = 0;
  let count = 0;
  for (const byte of bytes) {
    bits |= byte << count;
    count += 8;
    if (count < kBits) continue;
    codes[length++] = kFirst + (bits & 0x7fff);
    bits >>= kBits;
    count -= kBits;
  }
  if (count > 0) codes[length++] = kFirst + bits;
  codes[length] = kFirst + (count > 0 ? kBits - count : 0);
  return new TextDecoder('utf-16le').decode(codes);
}

export function bytesOfDense(text) {
  const letters = text.trim();
  const last = letters.length - 1;
  const unused = letters.charCodeAt(last) - kFirst;
  const bytes = new Uint8Array((last * kBits - unused) >> 3);
  let length = 0;
  let bits = 0;
  let count = 0;
  for (let at = 0; at < last; ++at) {
    bits |= (letters.charCodeAt(at) - kFirst) << count;
    count += kBits;
    for (; count >= 8 && length < bytes.length; count -= 8, bits >>= 8)
      bytes[length++] = bits & 255;
  }
  return bytes;
}

export function utf16(page) {
  const codes = new Uint16Array(page.length + 1);
  codes[0] = kByteOrderMark;
  for (let at = 0; at < page.length; ++at) codes[at + 1] = page.charCodeAt(at);
  return new Uint8Array(codes.buffer);
}
