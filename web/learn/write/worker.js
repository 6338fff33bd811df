// The worker in which a reader's program runs. tools/learn/run-page.mjs bundles it into one text.
//
// The frame gets one message, with a port. Then this scope loses postMessage: whatever a program
// sends, nobody listens. Only this file knows the port, and a program that had it could answer in
// this file's place. An event of the port names it, so once a program is there, nothing that the
// program can replace is called with such an event.

/* global importScripts */

import { check } from '../raycaster/checks.js';
import { firstDifference } from '../raycaster/compare.js';
import { makeEye, makePicture, makeWorld } from '../raycaster/world.js';

const { port1: port, port2 } = new MessageChannel();
const send = port.postMessage.bind(port);
const { apply } = Reflect;
const dataOf = Object.getOwnPropertyDescriptor(MessageEvent.prototype, 'data').get;
const now = performance.now.bind(performance);
self.postMessage({ port: port2 }, [port2]);
for (const place of [self, Object.getPrototypeOf(self)]) delete place.postMessage;

let functions = null; // the program's, by name
let world = null;
let body = null; // who walks, for the program's own `move`

const kActions = {
  read({ scene, images }) {
    world = makeWorld(scene, images);
    return { leftOut: world.leftOut ?? [] };
  },

  draw({ view, fov, width, height, seconds }) {
    if (functions.draw === undefined) throw new ReferenceError('draw is not defined');
    const eye = makeEye(world, view, fov);
    const picture = makePicture(width, height);
    const { pixels } = picture;
    world.seconds = seconds;
    const begin = now();
    functions.draw(picture, world, eye);
    const milliseconds = now() - begin;
    // A copy, since the program may have kept the list; opaque, as pictures on a screen are.
    const data = pixels.slice();
    for (let alpha = 3; alpha < data.length; alpha += 4) data[alpha] = 255;
    return { milliseconds, picture: { width, height, data } };
  },

  check({ chapter, expected }) {
    return { checks: check(chapter, functions, expected, world) };
  },

  explain({ chapter, view, fov, seconds, ...pictures }) {
    world.seconds = seconds;
    const eye = makeEye(world, view, fov);
    return { difference: firstDifference(chapter, { ...pictures, functions, world, eye }) };
  },

  // Walks `ahead` and `aside` units from the eye, and returns the eye's new place.
  move({ view, ahead, aside }) {
    const kEyeHeight = 0.5; // above the feet
    const { map, x, y, z } = view;
    if (body === null || body.map !== map || Math.hypot(body.x - x, body.y - y) > 0.01)
      body = { map, x, y, z: z - kEyeHeight, halfWidth: 0.2, height: 0.72, step: 0.5 };
    const angle = (view.heading * Math.PI) / 180;
    const [east, south] = [Math.cos(angle), Math.sin(angle)];
    functions.move(world, body, ahead * east - aside * south, ahead * south + aside * east);
    return { view: { ...view, x: body.x, y: body.y, z: body.z + kEyeHeight } };
  },
};

port.onmessage = (event) => {
  const { id, action, detail } = apply(dataOf, event, []);
  // Whatever goes wrong while the program is read arrives at the frame as an event, with its place.
  if (action === 'read') read(detail.text);
  try {
    const answer = kActions[action](detail);
    send({ id, answer }, answer.picture === undefined ? [] : [answer.picture.data.buffer]);
  } catch (error) {
    send({ id, error: described(error) });
  }
};

function described(error) {
  if (!(error instanceof Error))
    return { name: 'Error', message: `The program threw ${String(error)}.`, stack: '' };
  const { name, message, stack } = error;
  return { name: String(name), message: String(message), stack: String(stack ?? '') };
}

// importScripts tells the place of an error of grammar in all browsers, unlike a worker's own
// script.
function read(text) {
  self.takeProgram = (program) => {
    functions = program;
    delete self.takeProgram;
  };
  const address = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
  importScripts(address);
  URL.revokeObjectURL(address);
}
