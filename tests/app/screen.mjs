// A virtual display and the program in it: real windows, keys and pixels without a desktop.
//
//     const screen = await Screen.open(800, 600);
//     const program = await screen.start(['scene.json']);
//     program.keys('w');                    xdotool's names of keys
//     screen.picture({x, y, width, height}) bytes R, G, B
//     await screen.close();

import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';

export const root = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
export const program = join(root, 'build/native/bin/slicecast');

// Why there can be no virtual display here, or false.
export const noScreen = ['Xvfb', 'xdotool'].some((name) => spawnSync(name, ['-help']).error)
  ? 'Xvfb and xdotool are needed'
  : false;

// Looks again and again until `look` gives something; fails with `what` after some seconds.
export async function eventually(what, look, seconds = 20) {
  for (
    const begin = performance.now();
    performance.now() - begin < 1000 * seconds;
    await sleep(30)
  ) {
    const found = await look();
    if (found) return found;
  }
  throw new Error(`${what}: not within ${seconds} s`);
}

export class Screen {
  #server;
  #folder = mkdtempSync(join(tmpdir(), 'slicecast-screen-'));
  #programs = [];

  // The server picks a free number and tells it.
  static async open(width, height) {
    const screen = new Screen();
    const args = [
      '-displayfd',
      '3',
      '-screen',
      '0',
      `${width}x${height}x24`,
      '-fbdir',
      screen.#folder,
      '-nocursor',
      '-nolisten',
      'tcp',
      '-noreset',
    ];
    screen.#server = spawn('Xvfb', args, { stdio: ['ignore', 'ignore', 'ignore', 'pipe'] });
    const number = await new Promise((found, failed) => {
      screen.#server.once('error', failed);
      screen.#server.once('exit', () => failed(new Error('Xvfb ended')));
      let text = '';
      screen.#server.stdio[3].on('data', (data) => {
        text += data;
        if (text.includes('\n')) found(text.trim());
      });
    });
    screen.display = `:${number}`;
    return screen;
  }

  get environment() {
    return { ...process.env, DISPLAY: this.display, SDL_VIDEODRIVER: 'x11' };
  }

  xdotool(...args) {
    const result = spawnSync('xdotool', args.map(String), {
      env: this.environment,
      encoding: 'utf8',
    });
    return result.status === 0 ? result.stdout.trim() : '';
  }

  // Starts the program and waits for its window. `options` as of spawn: {cwd, env}.
  async start(args, options) {
    const started = new Program(this, args, options);
    this.#programs.push(started);
    await eventually('a window', () => started.ended !== undefined || started.findWindow());
    return started;
  }

  // Xvfb keeps the screen in a file of the form that xwd writes: a header of big-endian numbers,
  // colours, rows.
  picture({ x, y, width, height }) {
    const file = readFileSync(join(this.#folder, 'Xvfb_screen0'));
    const field = (i) => file.readUInt32BE(4 * i);
    const [headerSize, bytesPerRow, colours] = [field(0), field(12), field(19)];
    const start = headerSize + colours * 12;
    const pixels = Buffer.alloc(width * height * 3);
    for (let row = 0, to = 0; row < height; ++row) {
      let from = start + (y + row) * bytesPerRow + x * 4;
      for (let column = 0; column < width; ++column, from += 4) {
        pixels[to++] = file[from + 2];
        pixels[to++] = file[from + 1];
        pixels[to++] = file[from];
      }
    }
    return pixels;
  }

  async close() {
    for (const started of this.#programs) started.kill();
    if (this.#server.exitCode === null && this.#server.signalCode === null) {
      const ended = new Promise((done) => this.#server.once('exit', done));
      this.#server.kill();
      await ended;
    }
    rmSync(this.#folder, { recursive: true, force: true });
  }
}

class Program {
  #screen;
  #process;

  constructor(screen, args, { cwd, env = {} } = {}) {
    this.#screen = screen;
    this.errors = '';
    this.#process = spawn(program, args.map(String), {
      cwd,
      env: { ...screen.environment, ...env },
      stdio: ['ignore', 'ignore', 'pipe'],
    });
    this.#process.stderr.on('data', (data) => (this.errors += data));
    this.#process.once('exit', (status) => (this.ended = status));
  }

  findWindow() {
    this.window = this.#screen
      .xdotool('search', '--onlyvisible', '--pid', this.#process.pid)
      .split('\n')
      .pop();
    return this.window;
  }

  get title() {
    return this.#screen.xdotool('getwindowname', this.window);
  }

  // Where the window is: {x, y, width, height}.
  get place() {
    const values = Object.fromEntries(
      this.#screen
        .xdotool('getwindowgeometry', '--shell', this.window)
        .split('\n')
        .map((line) => line.split('=')),
    );
    return {
      x: Number(values.X),
      y: Number(values.Y),
      width: Number(values.WIDTH),
      height: Number(values.HEIGHT),
    };
  }

  picture() {
    return this.#screen.picture(this.place);
  }

  keys(...names) {
    this.#screen.xdotool('windowfocus', '--sync', this.window);
    for (const name of names) this.#screen.xdotool('key', '--clearmodifiers', name);
  }

  kill() {
    this.#process.kill('SIGKILL');
  }
}
