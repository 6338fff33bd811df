// Fetches bytes, and finds out why a fetch failed: a browser does not tell a page the cause, so
// this asks the server a second time.
//
//     const bytes = await fetchBytes(address, (loaded, total) => {...}, kMostSceneBytes);
//
// It throws an Error that says what happened, with one of the codes of element/faults.js: 'fetch'
// (also for more bytes than the limit), 'cors', 'mime' or 'csp'.

import { kMostFileBytes, tooLong } from './limits.js';
import { coded } from './trouble.js';

const kViolationMilliseconds = 50; // the event of a CSP violation comes after the failure
const kOnePiece = 131072; // bytes; files up to this size are read without reporting progress
const kProbeMilliseconds = 4000; // how long the second request waits for an answer

let cache = 'default';
const redirects = new Map(); // address -> its last redirect
const strangers = new Set(); // origins that only a redirect has named

// Where the bytes of an address really came from, after redirects, as a URL: relative names resolve
// there.
export function finalAddress(address) {
  const { href } = new URL(address);
  return new URL(redirects.get(href) ?? href);
}

// From now on, cached files are checked with their server: somebody tries again.
export function askAnew() {
  cache = 'no-cache';
}

// `total` is never below `loaded`: the length of a compressed answer is not known beforehand.
export async function fetchBytes(address, onBytes = () => {}, most = kMostFileBytes) {
  const { href, protocol } = new URL(address);
  if (protocol === 'data:') return bytesIn(href);
  const bytes = await readBody(await fetchResponse(address), onBytes, most);
  if (!isPage(bytes)) return bytes;
  throw coded(
    'mime',
    'the server answers with a web page, as some servers do for unknown addresses',
  );
}

// The bytes of a data: address. Bundlers make such ones of small files, and a page's policy may
// forbid to fetch them.
function bytesIn(href) {
  const [, base64, data] = /^[^,]*?(;base64)?,([^#]*)/i.exec(href) ?? [];
  try {
    const text = data.replace(/%([\da-f]{2})/gi, (_, code) => String.fromCharCode(`0x${code}`));
    return Uint8Array.from(base64 ? atob(text) : text, (letter) => letter.charCodeAt(0));
  } catch {
    throw coded('fetch', 'the address is not valid');
  }
}

// Returns the response with its body unread.
export async function fetchResponse(address) {
  const violations = listenForViolations();
  let response;
  try {
    response = await fetch(address, { cache });
  } catch {
    throw await causeOf(address, violations);
  } finally {
    violations.stop();
  }
  const { href, origin } = new URL(address);
  redirects.delete(href);
  if (response.redirected) {
    redirects.set(href, response.url);
    const last = new URL(response.url).origin;
    if (last !== origin) strangers.add(last);
  }
  if (!response.ok)
    throw coded('fetch', `the server answers ${response.status} ${response.statusText}`.trim());
  return response;
}

export async function readBody(response, onBytes, most = kMostFileBytes) {
  const total = response.headers.has('Content-Encoding')
    ? 0
    : Number(response.headers.get('Content-Length') ?? 0);
  // Another origin may hide the header that says that its answer is compressed.
  const isShort = total > 0 && total <= kOnePiece && response.type === 'basic';
  if (response.body === null || isShort) return readPiece(response, total, onBytes);

  const chunks = [];
  let loaded = 0;
  const reader = response.body.getReader();
  for (;;) {
    const found = Math.max(loaded, total);
    if (found > most) {
      reader.cancel();
      throw tooLong(found, most);
    }
    if (loaded > 0) onBytes(loaded, found);
    const { done, value } = await reader.read().catch(() => {
      throw coded('fetch', `the server stopped answering after ${loaded} bytes`);
    });
    if (done) break;
    chunks.push(value);
    loaded += value.length;
  }
  const bytes = new Uint8Array(loaded);
  let at = 0;
  for (const chunk of chunks) {
    bytes.set(chunk, at);
    at += chunk.length;
  }
  return bytes;
}

// Reading in pieces is slower, so short files are read at once.
async function readPiece(response, total, onBytes) {
  const bytes = await response.arrayBuffer().catch(() => {
    throw coded('fetch', `the server stopped answering before all ${total} bytes were there`);
  });
  onBytes(bytes.byteLength, Math.max(total, bytes.byteLength));
  return new Uint8Array(bytes);
}

// Finds out why a module script was refused: an Error with a code. `reason` is the browser's
// message.
export async function whyNoScript(address, reason) {
  let response;
  try {
    response = await fetchResponse(address);
  } catch (error) {
    return error;
  }
  await response.body?.cancel();
  const type = (response.headers.get('Content-Type') ?? '').split(';', 1)[0].trim();
  if (/^(text|application)\/(x-)?(java|ecma)script$/i.test(type)) return coded('engine', reason);
  return coded(
    'mime',
    `the server sends it as ${type === '' ? 'no type at all' : type}, but a script must be text/javascript`,
  );
}

// Collects what the page's Content-Security-Policy refuses until stop().
export function listenForViolations() {
  const refused = [];
  const hear = ({ effectiveDirective, blockedURI, disposition }) => {
    if (disposition === 'enforce')
      refused.push({ directive: effectiveDirective, address: blockedURI });
  };
  globalThis.document?.addEventListener('securitypolicyviolation', hear);
  return {
    refused,
    stop: () => globalThis.document?.removeEventListener('securitypolicyviolation', hear),
  };
}

// A fetch failed without an answer. A request with no-cors succeeds whatever headers the server
// sends, though the page cannot read the answer; so it tells a CORS error from a dead server. Hosts
// that only a redirect has named are not asked again.
async function causeOf(address, { refused }) {
  await new Promise((resolve) => setTimeout(resolve, kViolationMilliseconds));
  // Ignores other addresses that the policy refuses meanwhile, for instance of trackers. For data:
  // and blob: addresses the browser reports only the protocol.
  const { href, origin, protocol } = new URL(address);
  if (protocol === 'file:')
    return coded(
      'fetch',
      'a page that was opened as a file may not read others; open it from a server, such as `npx serve`',
    );
  const names = [href.replace(/#.*/s, ''), origin, protocol.slice(0, -1)];
  const isRefused = refused.some(
    (one) => one.directive === 'connect-src' && names.includes(one.address),
  );
  if (isRefused)
    return coded('csp', "the page's Content-Security-Policy does not allow it (connect-src)");
  if (strangers.has(origin))
    return coded('fetch', 'the server does not answer, or does not let this page read its answer');
  // The page's own server answers whatever it sends on to.
  const isOwn = origin === globalThis.origin;
  const answers = await fetch(address, {
    ...(isOwn ? { redirect: 'manual' } : { mode: 'no-cors' }),
    cache: 'no-store',
    signal: AbortSignal.timeout?.(kProbeMilliseconds),
  }).then(
    () => true,
    () => false,
  );
  if (answers)
    return coded(
      'cors',
      'the server answers, but does not allow pages of other origins to read it',
    );
  return coded('fetch', 'the server does not answer');
}

function isPage(bytes) {
  return /^\s*<(!doctype html|html|head|body|title)/i.test(
    new TextDecoder().decode(bytes.subarray(0, 64)),
  );
}
