// A room whose picture is known in advance: every wall has its own colour, and light
// plays no part.
//
//     7 x 7 tiles; the outer ring is walls of height 1: north red, east green, south blue, west
//     yellow; grey floor, blue-grey sky. The player stands in the middle and looks east.

import { png } from './png.mjs';

export const kRed = [200, 40, 40];
export const kGreen = [40, 180, 60];
export const kBlue = [50, 70, 210];
export const kYellow = [230, 200, 50];
export const kGrey = [120, 120, 120];
export const kSky = [0x88, 0xa0, 0xb8];

const kPictures = { red: kRed, green: kGreen, blue: kBlue, yellow: kYellow, grey: kGrey };

export function roomScene({ title = 'The coloured room', folder = 'pictures/' } = {}) {
  const open = '#.....#';
  return {
    title,
    textures: Object.fromEntries(
      Object.keys(kPictures).map((name) => [name, `${folder}${name}.png`]),
    ),
    // A wall is seen from inside the room: the one in the north shows its south face.
    blueprints: {
      wall: {
        faces: {
          south: 'red',
          west: 'green',
          north: 'blue',
          east: 'yellow',
          top: 'grey',
          bottom: 'grey',
        },
      },
    },
    legend: { '#': 'wall' },
    maps: [
      {
        name: 'room',
        levels: [['#######', open, open, open, open, open, '#######']],
        floor: 'grey',
        sky: '#88a0b8',
        light: { on: false },
      },
    ],
    start: { x: 3.5, y: 3.5, heading: 0 },
  };
}

export function roomPictures(prefix = '') {
  return Object.fromEntries(
    Object.entries(kPictures).map(([name, colour]) => [
      `${prefix}${name}.png`,
      png(8, () => colour),
    ]),
  );
}

// Files for a server that make the room the first scene of the page's list.
export function roomFiles(options = {}) {
  return {
    'scenes/index.json': JSON.stringify([
      {
        file: 'room.json',
        title: 'The coloured room',
        about: 'Four walls.',
        poster: 'posters/room.png',
      },
      {
        file: 'other.json',
        title: 'The other room',
        about: 'Four walls too.',
        poster: 'posters/other.png',
      },
    ]),
    'scenes/room.json': JSON.stringify(roomScene(options)),
    'scenes/other.json': JSON.stringify({
      ...roomScene({ ...options, title: 'The other room' }),
      start: { x: 3.5, y: 3.5, heading: 90 },
    }),
    ...roomPictures('scenes/pictures/'),
    'scenes/posters/room.png': png(8, () => kGreen),
    'scenes/posters/other.png': png(8, () => kBlue),
  };
}
