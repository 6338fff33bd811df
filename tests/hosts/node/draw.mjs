// A program under Node: draws the shipped scene into the file that is named.

import { writeFile } from 'node:fs/promises';
import { load } from 'slicecast/node';

const scene = await load('first-walk');
await writeFile(process.argv[2], await scene.png({ width: 320, height: 200 }));
scene.free();
