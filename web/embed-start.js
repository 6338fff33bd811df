// Says what keeps the frame's modules from loading, which nothing in them can. A classic script: it
// loads where they are refused.
window.addEventListener(
  'error',
  function (event) {
    'use strict';
    if (
      !(event.target instanceof HTMLScriptElement) ||
      document.body.getAttribute('data-state') !== null
    )
      return;
    document.getElementById('trouble-title').textContent = 'The picture’s program is refused';
    document.getElementById('trouble-text').textContent =
      self.origin === 'null'
        ? 'This frame is sandboxed, so it has no origin of its own, and ' +
          location.host +
          ' does not allow others to load its scripts. ' +
          'Its server has to send "Access-Control-Allow-Origin: *", or the frame needs allow-same-origin beside allow-scripts.'
        : event.target.src +
          ' or a script that it needs could not be loaded. The folder has to be copied as a whole, and served as it is.';
    document.getElementById('trouble').hidden = false;
  },
  true,
);
