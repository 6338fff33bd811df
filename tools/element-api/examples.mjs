// The snippets of the documentation. Those under `live` stand in the page twice: to be read, and at work.

export const opening = `<ray-caster scene="castle" tour="tours/castle.txt" controls
            label="The courtyard of a castle, its keep behind a moat">
</ray-caster>`;

export const begin = `<script type="module" src="slicecast/ray-caster.js"></script>

<ray-caster scene="castle" controls label="The courtyard of a castle">
  <p>This picture moves where JavaScript and WebAssembly are at hand.</p>
</ray-caster>`;

export const bundler = `npm install slicecast

import 'slicecast';`;

export const vite = `// vite.config.js
export default { optimizeDeps: { exclude: ['slicecast'] } };`;

export const iframe = `<iframe src="slicecast/embed.html?scene=castle&amp;controls" title="The courtyard of a castle"
        width="640" height="400" allow="fullscreen"></iframe>`;

export const node = `import { writeFile } from 'node:fs/promises';
import { load } from 'slicecast/node';

const scene = await load('worlds/my-scene.json');     // or an address, an object, the name of a shipped scene
for (const { place, found, expected } of scene.warnings) console.warn(place, found, expected);
scene.set('fov', 75);
scene.look({ x: 12.5, y: 8, z: 1.6, heading: 90 });
await writeFile('view.png', await scene.png({ width: 1280, height: 800 }));
scene.free();`;

export const live = [
  {
    title: 'A scene typed into the page',
    text: 'Rows of characters, seen from above; the arrow is where one starts. A scene in JSON goes into a script of type application/json.',
    code: `<ray-caster view="4.2,6.4,0.6,292" label="A walled garden with a door, a pond and birches">
  <script type="text/plain" data-rows>
    BBBBBBOBBBBBBB
    B            B
    B  t   ...   B
    B      .~.   B
    B  *   ...  tB
    B       .    B
    B.......>....+
    B   t     *  B
    BBBBBBBBBBBBBB
  </script>
</ray-caster>`,
  },
  {
    title: 'The fish eye, an old way of drawing',
    text: 'Every switch of the engine is an option, the mistakes that lessons show among them.',
    code: `<ray-caster scene="harbour-town" options="fov=110 method=classic classic.projection=equalAngles"
            label="A harbour town, its houses bent as by a fish eye">
</ray-caster>`,
  },
  {
    title: 'What one slice meets',
    text: 'Overlays are drawn from what the renderer itself has done.',
    code: `<ray-caster scene="first-steps" overlay="minimap minimapRays inspector" size="960x600"
            label="A room, its map with rays, and one slice from the side">
</ray-caster>`,
  },
  {
    title: 'Asked by a script',
    text: 'The picture is a question and answer away: here the middle slice says what it meets, as you go.',
    code: `<ray-caster id="asked" scene="garden" controls label="A garden in spring"></ray-caster>
<pre id="answer">Nothing yet</pre>

<script type="module">
  const garden = document.getElementById('asked');
  garden.addEventListener('viewchange', () => {
    const { hits } = garden.hits(Math.floor(garden.picture.width / 2));
    document.getElementById('answer').textContent =
      hits.map(({ blueprint, depth }) => \`\${depth.toFixed(1).padStart(6)}  \${blueprint}\`).join('\\n') || 'Nothing but sky';
  });
</script>`,
  },
];
