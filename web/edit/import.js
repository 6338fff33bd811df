// The importers as one script of the page, which loads when a map from elsewhere is opened.

export { makeScene, readForeign } from './import/index.js';
export { importDialog } from './files/import-dialog.js';
