// Says at once what keeps the page from starting. A classic script in the oldest JavaScript: it
// must run where the modules cannot.
(function () {
  'use strict';

  function findTrouble() {
    if (location.protocol === 'file:') {
      return {
        title: 'This page wants a server',
        text:
          'It was opened as a file, and browsers do not let a file load the engine. Run tools/play in the project and open the address that it prints, ' +
          'or put this folder on any static web server.',
      };
    }
    if (typeof WebAssembly !== 'object' || typeof WebAssembly.validate !== 'function') {
      return {
        title: 'This browser has no WebAssembly',
        text:
          'The engine is a WebAssembly program. It needs a current browser with WebAssembly switched on; ' +
          'some browsers switch it off in their strictest security mode.',
      };
    }
    if (!('noModule' in HTMLScriptElement.prototype) || typeof HTMLDialogElement !== 'function') {
      return {
        title: 'This browser is too old',
        text: 'The page needs JavaScript modules and dialogs, which all current browsers have.',
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
