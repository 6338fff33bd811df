// Makes a file of a program that runs by itself: with its world, offline.
//
//     const html = await exportPage('write/export.html', { text, data, view, fov, chapter })
//
// `data` is readScene's. export-player.js reads what is put into the page here.

export async function exportPage(address, { text, data, view, fov, chapter }) {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address} cannot be loaded (${answer.status}).`);
  const page = await answer.text();
  const files = {};
  for (const [name, bytes] of Object.entries(data.files)) files[name] = await base64(bytes);
  const world = { scene: data.scene, files, view, fov, chapter };
  // Nothing inside may end its element.
  const json = JSON.stringify(world).replaceAll('<', '\\u003c');
  const program = `'use strict';\n${text}`
    .replace(/<(?=\/script)/gi, '<\\')
    .replaceAll('<!--', '< !--');
  return page.replace('/* WORLD */', () => json).replace('/* PROGRAM */', () => program);
}

function base64(bytes) {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(reader.result.slice(reader.result.indexOf(',') + 1));
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(new Blob([bytes]));
  });
}
