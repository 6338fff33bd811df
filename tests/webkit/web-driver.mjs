// WebKit as WebKitGTK has it, driven over WebDriver: no more of it than the tests need.
//
//     const browser = await Browser.open(environment);        with a DISPLAY
//     await browser.go(address);
//     await browser.until('return document.readyState === "complete"');
//     await browser.run('return 1 + arguments[0]', 2);        waits for promises
//     await browser.click('#play');   await browser.holdKey('w', 500);
//     await browser.close();

import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { delimiter, join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';

const kWaitMilliseconds = 60000; // a first start on a busy machine takes long

const driver = (process.env.PATH ?? '')
  .split(delimiter)
  .map((folder) => join(folder, 'WebKitWebDriver'))
  .find(existsSync);

// Each version of WebKitGTK has its browser in a folder of its own, beside its libraries.
const miniBrowser = ['/usr/lib', '/usr/libexec']
  .filter(existsSync)
  .flatMap((folder) => [folder, ...inside(folder, /-linux-gnu$/)])
  .flatMap((folder) => inside(folder, /^webkit2?gtk-/))
  .map((folder) => join(folder, 'MiniBrowser'))
  .findLast(existsSync);

// Why it cannot be driven here, or false.
export const noWebKit =
  (driver === undefined || miniBrowser === undefined) &&
  'there is no WebKitWebDriver with a MiniBrowser; tools/setup webkit installs them on Debian';

function inside(folder, pattern) {
  return readdirSync(folder)
    .filter((name) => pattern.test(name))
    .sort()
    .map((name) => join(folder, name));
}

async function freePort() {
  const server = createServer();
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  const { port } = server.address();
  await new Promise((done) => server.close(done));
  return port;
}

export class Browser {
  #home = mkdtempSync(join(tmpdir(), 'slicecast-webkit-'));
  #process;
  #address;
  #session;

  static async open(environment) {
    const browser = new Browser();
    const port = await freePort();
    browser.#address = `http://127.0.0.1:${port}`;
    browser.#process = spawn(driver, [`--port=${port}`], {
      stdio: 'ignore',
      env: { ...environment, HOME: browser.#home, XDG_RUNTIME_DIR: browser.#home },
    });
    try {
      await eventually('a driver', () => browser.#ask('GET', '/status').catch(() => null));
      const { sessionId } = await browser.#ask('POST', '/session', {
        capabilities: {
          alwaysMatch: {
            'webkitgtk:browserOptions': { binary: miniBrowser, args: ['--automation'] },
          },
        },
      });
      browser.#session = `/session/${sessionId}`;
      await browser.#ask('POST', `${browser.#session}/timeouts`, { script: kWaitMilliseconds });
    } catch (error) {
      await browser.close();
      throw error;
    }
    return browser;
  }

  async #ask(method, path, body) {
    const answer = await fetch(this.#address + path, {
      method,
      body: body && JSON.stringify(body),
    });
    const { value } = await answer.json();
    if (!answer.ok) throw new Error(`${value.error}: ${value.message}`);
    return value;
  }

  go(url) {
    return this.#ask('POST', `${this.#session}/url`, { url });
  }

  run(script, ...args) {
    return this.#ask('POST', `${this.#session}/execute/sync`, { script, args });
  }

  until(script, ...args) {
    return eventually(script, () => this.run(script, ...args));
  }

  async click(selector) {
    const found = await this.#ask('POST', `${this.#session}/element`, {
      using: 'css selector',
      value: selector,
    });
    await this.#ask('POST', `${this.#session}/element/${Object.values(found)[0]}/click`, {});
  }

  async holdKey(key, milliseconds) {
    const actions = [
      { type: 'keyDown', value: key },
      { type: 'pause', duration: milliseconds },
      { type: 'keyUp', value: key },
    ];
    await this.#ask('POST', `${this.#session}/actions`, {
      actions: [{ type: 'key', id: 'keyboard', actions }],
    });
  }

  async close() {
    if (this.#session) await this.#ask('DELETE', this.#session).catch(() => {});
    const ended = new Promise((done) => this.#process.once('exit', done));
    this.#process.kill();
    await ended;
    rmSync(this.#home, { recursive: true, force: true, maxRetries: 3 });
  }
}

async function eventually(what, look) {
  for (const begin = Date.now(); Date.now() - begin < kWaitMilliseconds; await sleep(50)) {
    const found = await look();
    if (found) return found;
  }
  throw new Error(`${what}: not within ${kWaitMilliseconds / 1000} s`);
}
