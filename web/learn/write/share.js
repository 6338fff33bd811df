// Programs as codes for addresses: the text, deflated, in the letters of base64url.
//
//     await codeOf(text)                  // '1.q1YqyUhV...'
//     await textOf(code)                  // the text; throws an Error if it is not a code
//     codeIn('#program=1.q1YqyUhV...')    // the code in an address's fragment, or null

const kVersion = '1.';
const kLongest = 200000; // characters of a program: far more than a raycaster has

export async function codeOf(text) {
  const bytes = await through(new CompressionStream('deflate-raw'), new TextEncoder().encode(text));
  const letters = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
  return kVersion + letters.replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

export async function textOf(code) {
  if (!/^1\.[\w-]+$/.test(code)) throw new Error('This link holds no program.');
  try {
    const letters = code.slice(kVersion.length).replaceAll('-', '+').replaceAll('_', '/');
    const bytes = Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0));
    const plain = await through(new DecompressionStream('deflate-raw'), bytes);
    return new TextDecoder('utf-8', { fatal: true }).decode(plain);
  } catch {
    throw new Error('The program in this link is damaged: it may have been cut off.');
  }
}

export function codeIn(fragment) {
  return /(?:^#|&)program=([^&]*)/.exec(fragment)?.[1] ?? null;
}

async function through(stream, bytes) {
  const writer = stream.writable.getWriter();
  // What goes wrong here shows when reading, too.
  writer.write(bytes).catch(() => {});
  writer.close().catch(() => {});
  const parts = [];
  let length = 0;
  const reader = stream.readable.getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    // A few letters can stand for gigabytes.
    if (length > kLongest) {
      await reader.cancel().catch(() => {});
      throw new Error('The program is too long.');
    }
    parts.push(value);
  }
  const whole = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}
