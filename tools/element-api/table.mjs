// Reads the table of the element's interface.

import { readFileSync } from 'node:fs';

export const table = JSON.parse(
  readFileSync(new URL('../../web/element/api.json', import.meta.url), 'utf8'),
);
