// Imports a script that may not be there, and finds out why it is not.
//
//     const module = await importScript(() => import('../ray-caster-rows.js'), 'The rows could not be read');      // throws a Trouble of that title

import { whyNoScript } from './fetch-bytes.js';
import { Trouble, coded } from './trouble.js';

let retries = 0;

// The address stands in the import itself, as a literal: that is how bundlers find the file.
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
    // A browser remembers which module it could not get; another address makes it ask again.
    return import(/* @vite-ignore */ `${address}?again=${++retries}`).catch(() =>
      Promise.reject(because(address, cause)),
    );
  }
}
