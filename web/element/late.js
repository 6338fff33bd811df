// The parts of <ray-caster> that come later than its script, each once for the page; what could not
// come is asked for again. They throw a Trouble where they cannot come.

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
