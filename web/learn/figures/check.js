// Finds what an author of a figure has left out or misspelt.
//
//     checkFigure(figure);       // throws an Error with a line for each mistake

import { unknown } from '../../engine/nearest-name.js';

const kFigure = [
  'scene',
  'view',
  'size',
  'options',
  'state',
  'controls',
  'rows',
  'numbers',
  'says',
  'input',
  'setup',
  'check',
  'world',
  'tools',
];
// What views are made of: options that a view does not know stay in it.
const kParts = [
  'kind',
  'title',
  'share',
  'id',
  'when',
  'label',
  'height',
  'markup',
  'knobs',
  'handles',
  'point',
  'click',
  'walk',
  'options',
  'alt',
  'mark',
  'left',
  'right',
  'labels',
  'paint',
];
const kSide = ['title', 'options', 'oldWay', 'draw'];
// Further options of views, which may be meant.
const kOptions = `levels map window ray lit order marks depths fov objects heights column tallest
  level blocks over runs sights plane edges mirror depth names rows pick tall step run grid of
  columns items current caption limit code html lines marked first x y`.split(/\s+/);

export function checkFigure(figure) {
  const faults = [];
  const checkKeys = (place, what, given, known, meant = known) => {
    for (const key of Object.keys(given))
      if (!known.includes(key)) faults.push(`${place}: ${unknown(what, key, meant)}`);
  };
  checkKeys('figure', 'field', figure, kFigure);
  const { scene, rows, controls = [] } = figure;
  if (typeof scene !== 'string' && (typeof scene !== 'object' || scene === null))
    faults.push(`scene: found ${scene}, expected the name of a scene file, or a scene`);
  if (!Array.isArray(rows) || rows.length === 0)
    faults.push('rows: found none, expected a list of rows, as in rows: [[picture(), mapView()]]');
  else
    rows.forEach((views, row) => {
      if (!Array.isArray(views))
        faults.push(`rows[${row}]: found a view, expected a list of views, as in [picture()]`);
      else views.forEach((view, place) => checkView(`rows[${row}][${place}]`, view));
    });
  controls.forEach((control, index) => {
    if (typeof control?.markup !== 'function')
      faults.push(
        `controls[${index}]: found ${typeof control}, expected a control, as slider() returns`,
      );
  });
  if (faults.length > 0) throw new Error(`The figure cannot be drawn.\n${faults.join('\n')}`);

  function checkView(place, view) {
    if (typeof view?.markup !== 'function') {
      faults.push(`${place}: found ${typeof view}, expected a view, as picture() returns`);
      return;
    }
    checkKeys(place, 'option', view, kParts, [...kParts, ...kOptions]);
    for (const side of ['left', 'right'])
      checkKeys(`${place}.${side}`, 'field', view[side] ?? {}, kSide);
  }
}
