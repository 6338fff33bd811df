// Folders to run the command `slicecast` in, which lies in HOME/slicecast/node.
//
//     const { folder, call, read } = await folderWith(home, { 'maps/yard.json': text });
//     await read('a.json')               // its text
//     await call('import', 'a.tmx')      // {status, stdout, stderr}

import { execFile } from 'node:child_process';
import { mkdir, mkdtemp, readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';

export async function folderWith(home, files) {
  const folder = await mkdtemp(path.join(home, 'work-'));
  for (const [name, content] of Object.entries(files)) {
    await mkdir(path.dirname(path.join(folder, name)), { recursive: true });
    await writeFile(path.join(folder, name), content);
  }
  const call = (...words) =>
    new Promise((resolve) => {
      const command = path.join(home, 'slicecast/node/command.js');
      execFile(process.execPath, [command, ...words], { cwd: folder }, (error, stdout, stderr) =>
        resolve({ status: error?.code ?? 0, stdout, stderr }),
      );
    });
  return {
    folder,
    call,
    read: (name, encoding = 'utf8') => readFile(path.join(folder, name), encoding),
  };
}
