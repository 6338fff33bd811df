// The parts of <ray-caster> that come later than its script, each fetched once for the page. They throw a Trouble where they cannot come.

import { importScript } from '../import-script.js';

const bring = (load) => importScript(load, 'A part of the element could not be loaded');

export const bringSteering = () => bring(() => import('../ray-caster-steering.js'));
export const bringRows = () => bring(() => import('../ray-caster-rows.js'));
