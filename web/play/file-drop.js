// Takes files from the visitor's disk: dropped anywhere on the page, or chosen in the browser's
// dialog.
//
//     listenForFiles({input, onEntries})
//
// onEntries gets a promise of the entries that dropped-scene.js describes.

import { chosenEntries, droppedEntries } from './dropped-scene.js';

export function listenForFiles({ input, onEntries }) {
  const holdsFiles = (event) => event.dataTransfer.types.includes('Files');
  const showHint = (shown) => document.body.classList.toggle('dropping', shown);
  window.addEventListener('dragover', (event) => {
    if (!holdsFiles(event)) return;
    event.preventDefault();
    showHint(true);
  });
  window.addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) showHint(false);
  });
  window.addEventListener('drop', (event) => {
    showHint(false);
    if (!holdsFiles(event)) return;
    event.preventDefault();
    onEntries(droppedEntries(event.dataTransfer));
  });
  input.addEventListener('change', () => {
    if (input.files.length === 0) return;
    onEntries(Promise.resolve(chosenEntries(input.files)));
    input.value = ''; // so that the same file can be chosen again
  });
}
