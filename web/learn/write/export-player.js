// Runs the program of a downloaded page, which stands in a script of its own before this one.

import { decodePng } from '../decode.js';
import { makeEye, makePicture, makeWorld } from '../raycaster/world.js';

/* global draw, move */ // the program's, if it has them

const kSize = [320, 200];
const kUnitsPerSecond = 3;
const kDegreesPerSecond = 120;
const kEyeHeight = 0.5; // above the feet

const { scene, files, view, fov } = JSON.parse(document.getElementById('world').textContent);
const images = {};
for (const [name, letters] of Object.entries(files))
  images[name] = decodePng(Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0)));
const world = makeWorld(scene, images);
const picture = makePicture(...kSize);
const canvas = document.querySelector('canvas');
const context = canvas.getContext('2d');
const message = document.getElementById('message');
const body = {
  map: view.map,
  x: view.x,
  y: view.y,
  z: view.z - kEyeHeight,
  halfWidth: 0.2,
  height: 0.72,
  step: 0.5,
};
let { heading } = view;

const held = new Set();
const kKeys = {
  ArrowUp: 'ahead', KeyW: 'ahead', ArrowDown: 'back', KeyS: 'back',
  ArrowLeft: 'left', ArrowRight: 'right', KeyA: 'aside-left', KeyD: 'aside-right',
}; // prettier-ignore
addEventListener('keydown', (event) => {
  const action = kKeys[event.code];
  if (action === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  held.add(action);
});
addEventListener('keyup', (event) => held.delete(kKeys[event.code]));
addEventListener('blur', () => held.clear());
for (const button of document.querySelectorAll('button')) {
  const { action } = button.dataset;
  button.addEventListener('pointerdown', () => held.add(action));
  for (const end of ['pointerup', 'pointerleave', 'pointercancel'])
    button.addEventListener(end, () => held.delete(action));
}

const axis = (more, less) => Number(held.has(more)) - Number(held.has(less));

function step(seconds) {
  heading = (heading + axis('right', 'left') * kDegreesPerSecond * seconds + 360) % 360;
  const ahead = axis('ahead', 'back') * kUnitsPerSecond * seconds;
  const aside = axis('aside-right', 'aside-left') * kUnitsPerSecond * seconds;
  world.seconds = (world.seconds ?? 0) + seconds;
  const angle = (heading * Math.PI) / 180;
  const east = ahead * Math.cos(angle) - aside * Math.sin(angle);
  const south = ahead * Math.sin(angle) + aside * Math.cos(angle);
  if (typeof move === 'function') {
    move(world, body, east, south);
  } else {
    body.x += east;
    body.y += south;
  }
}

let last = null;
function frame(now) {
  const seconds = last === null ? 0 : Math.min((now - last) / 1000, 0.1);
  const isFirst = last === null;
  last = now;
  try {
    if (held.size > 0 || isFirst || scene.maps.some(({ movers }) => movers !== undefined)) {
      step(seconds);
      const { map, x, y, z } = body;
      const eye = makeEye(world, { ...view, map, x, y, z: z + kEyeHeight, heading }, fov);
      draw(picture, world, eye);
      for (let at = 3; at < picture.pixels.length; at += 4) picture.pixels[at] = 255;
      context.putImageData(new ImageData(picture.pixels, ...kSize), 0, 0);
    }
    requestAnimationFrame(frame);
  } catch (error) {
    message.textContent = `The program stops: ${error.message}`;
  }
}
requestAnimationFrame(frame);
