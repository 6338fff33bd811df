// Imports a script, and finds out why if that fails. Throws a Trouble with the given title.
//
//     const module = await importScript(
//       () => import('../ray-caster-rows.js'), 'The rows could not be read');

import { whyNoScript } from './fetch-bytes.js';
import { Trouble, coded } from './trouble.js';

let retries = 0;

// Callers write the address as a literal in the import, so that bundlers find the file.
export async function importScript(load, title) {
  try {
    return await load();
  } catch (error) {
    const address = /\b(?:https?|blob|data|file):\S+/.exec(error.message)?.[0];
    const because = (where, cause) =>
      new Trouble(title, `${where}: ${cause.message}.`, [], cause.code);
    if (address === undefined) throw because('its script', coded('fetch', error.message));
    const cause = await whyNoScript(address, error.message);
    if (cause.code !== 'engine') throw because(address, cause);
    // Browsers remember that a module failed; another address makes them fetch it again.
    return import(/* @vite-ignore */ `${address}?again=${++retries}`).catch(() =>
      Promise.reject(because(address, cause)),
    );
  }
}
