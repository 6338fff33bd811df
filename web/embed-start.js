// Tells why the frame's modules failed to load. A classic script, because it must run even where
// modules are refused.
window.addEventListener(
  'error',
  function (event) {
    'use strict';
    if (
      !(event.target instanceof HTMLScriptElement) ||
      document.body.getAttribute('data-state') !== null
    )
      return;
    document.getElementById('trouble-title').textContent = 'The picture’s script was blocked';
    document.getElementById('trouble-text').textContent =
      self.origin === 'null'
        ? 'This frame is sandboxed, so it counts as another origin, and ' +
          location.host +
          ' does not let other origins load its scripts. ' +
          'Its server must send "Access-Control-Allow-Origin: *", or the frame needs allow-same-origin beside allow-scripts.'
        : event.target.src +
          ' or a script that it imports could not be loaded. Copy and serve the whole folder unchanged.';
    document.getElementById('trouble').hidden = false;
  },
  true,
);
