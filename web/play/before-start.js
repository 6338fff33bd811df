// Tells at once why the page cannot start. A classic script in old JavaScript, because it must run
// where modules cannot.
(function () {
  'use strict';

  function findTrouble() {
    if (location.protocol === 'file:') {
      return {
        title: 'This page needs a web server',
        text:
          'It was opened as a file, and browsers do not let a file load the engine. Run tools/play in the project and open the address that it prints, ' +
          'or put this folder on any static web server.',
      };
    }
    if (typeof WebAssembly !== 'object' || typeof WebAssembly.validate !== 'function') {
      return {
        title: 'This browser has no WebAssembly',
        text:
          'The engine is a WebAssembly program, so it needs a current browser with WebAssembly switched on. ' +
          'Some browsers switch it off in their strictest security mode.',
      };
    }
    if (!('noModule' in HTMLScriptElement.prototype) || typeof HTMLDialogElement !== 'function') {
      return {
        title: 'This browser is too old',
        text: 'The page needs JavaScript modules and dialogs, which all current browsers support.',
      };
    }
    return null;
  }

  var trouble = findTrouble();
  if (trouble === null) return;
  document.getElementById('trouble-title').textContent = trouble.title;
  document.getElementById('trouble-text').textContent = trouble.text;
  document.getElementById('trouble').hidden = false;
  document.body.setAttribute('data-state', 'impossible');
})();
