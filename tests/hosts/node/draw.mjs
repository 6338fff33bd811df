// A program under Node: draws the shipped scene into the file that is named.

import { writeFile } from 'node:fs/promises';
import { load } from 'slicecast/node';

const scene = await load('first-walk');
const png = scene.png({ width: 320, height: 200 });
// It shows the view at the moment of the call.
scene.look({ heading: 180 });
scene.free();
await writeFile(process.argv[2], await png);
