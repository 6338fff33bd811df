// Shared by the editor's tests: the page with a world in it, and questions to it.

import assert from 'node:assert/strict';
import { frames, openPage } from './browser.mjs';

export async function openEditor(t, browser, query = '?template=meadow', options = {}) {
  const opened = await openPage(t, browser, {
    query: `edit.html${query}`,
    viewport: { width: 1366, height: 768 },
    prepare: (_, context) =>
      context.addInitScript(() => localStorage.setItem('slicecast edit tour', 'yes')),
    ...options,
  });
  await opened.page.waitForFunction(() => document.body.dataset.state === 'ready');
  return opened;
}

export const told = (page, tell, argument) => page.evaluate(tell, argument);
export const textOf = (page) => told(page, () => window.slicecastEditor.scene.text);
export const settle = async (page) => {
  await told(page, () => window.slicecastEditor.sync.settled());
  await frames(page);
};
// The rows of a level, in the document and in the engine; they must be the same.
export async function rowsOf(page, level) {
  await settle(page);
  const [ours, theirs] = await told(
    page,
    (which) => {
      const { scene, caster, editor } = window.slicecastEditor;
      return [scene.rows(editor.map, which), caster.cells(editor.mapName)[which]];
    },
    level,
  );
  const dotted = (rows) => rows.map((row) => row.replaceAll(' ', '.'));
  if (ours.length > 0) assert.deepEqual(dotted(theirs), dotted(ours));
  return ours;
}
// Where a point of the world is in the window.
export const pointOf = (page, x, y, z) =>
  told(
    page,
    (place) => {
      const { clientX, clientY } = window.slicecastEditor.caster.project(...place);
      return [clientX, clientY];
    },
    [x, y, z],
  );
export async function lookAt(page, view) {
  await told(page, (wanted) => window.slicecastEditor.caster.look(wanted), {
    ...view,
    flying: true,
  });
  await frames(page);
}
