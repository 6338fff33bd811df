// Loads the parts of <ray-caster> that are not in its first script, each once per page; a part that
// failed is requested again next time. They throw a Trouble.

import { importScript } from '../engine/import-script.js';

function once(load) {
  let coming = null;
  return () => {
    coming ??= importScript(load, 'A part of the element could not be loaded').catch((error) => {
      coming = null;
      throw error;
    });
    return coming;
  };
}

export const bringSteering = once(() => import('../ray-caster-steering.js'));
export const bringMore = once(() => import('../ray-caster-more.js'));
export const bringRows = once(() => import('../ray-caster-rows.js'));
