// What one types into a page to show a world there. Takes names and titles; gives HTML.
//
//     tagFor({ name: 'yard', title: 'My yard' })
//     frameFor({ name: 'yard', title: 'My yard' })

const kEscapes = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;', "'": '&#39;' };

// For HTML, within quotes or not.
export const escaped = (text) => String(text).replace(/[&<>"']/g, (letter) => kEscapes[letter]);

export function tagFor({ name, title }) {
  return `<script type="module" src="slicecast/ray-caster.js"></script>
<ray-caster scene="${escaped(name)}" controls label="${escaped(title)}"></ray-caster>`;
}

export function frameFor({ name, title }) {
  return `<iframe src="slicecast/embed.html?scene=${encodeURIComponent(name)}" title="${escaped(title)}" width="640" height="400" allow="fullscreen; gamepad"></iframe>`;
}
