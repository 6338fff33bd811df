// The snippets of the element's page. Those in `live` appear twice: as text, and running.

export const opening = `<ray-caster scene="castle" tour="tours/castle.txt" controls
            label="A castle on a rock above the water, at sunset">
</ray-caster>`;

export const begin = `<script type="module" src="slicecast/ray-caster.js"></script>

<ray-caster scene="castle" controls label="A castle above the water">
  <p>This picture moves where JavaScript and WebAssembly are at hand.</p>
</ray-caster>`;

export const bundler = `import 'slicecast';
import 'slicecast/scenes/castle';     // now scene="castle" means it`;

export const ownScene = `import castle from 'slicecast/scenes/castle';

const brick = new URL('./brick.png', import.meta.url);
document.querySelector('ray-caster').scene =
  { ...castle, textures: { ...castle.textures, rock: brick } };`;

export const plugin = `// esbuild
import slicecast from 'slicecast/esbuild';
await build({ entryPoints: ['main.js'], outdir: 'dist', bundle: true,
              plugins: [slicecast()] });

// rollup.config.js
import slicecast from 'slicecast/rollup';
export default { plugins: [nodeResolve(), slicecast()], ... };`;

export const vite = `// vite.config.js
export default { optimizeDeps: { exclude: ['slicecast'] } };`;

export const home = '<meta name="slicecast-home" content="/slicecast/">';

export const jsx = `import 'slicecast/react';          // or slicecast/preact, slicecast/solid

<ray-caster scene="castle" controls label="A castle above the water"
            onready={({ detail }) => console.log(detail.title)} />`;

export const iframe = `<iframe src="slicecast/embed.html?scene=castle" title="A castle above the water"
        width="640" height="400" allow="fullscreen"></iframe>`;

export const messages = `const frame = document.querySelector('iframe');   // its address ends in &origin=https://your.page
const origin = 'https://slicecast.host';

const say = (message) =>
  frame.contentWindow.postMessage({ slicecast: 1, ...message }, origin);
say({ id: 1, call: 'look', arguments: ['4.5,2,0.6,90'] });
say({ id: 2, set: 'options', value: 'fov=75' });
say({ id: 3, get: 'currentView' });

addEventListener('message', ({ origin: from, source, data }) => {
  if (from !== origin || source !== frame.contentWindow) return;
  const { id, result, error, event, detail } = data;
  console.log(event === undefined ? [id, error ?? result] : [event, detail]);
});`;

export const node = `import { writeFile } from 'node:fs/promises';
import { load } from 'slicecast/node';

// A path; or an address, an object, the name of a shipped scene
const scene = await load('worlds/my-scene.json');
for (const { place, found } of scene.warnings) console.warn(place, found);
scene.set('fov', 75);
scene.look({ x: 12.5, y: 8, z: 1.6, heading: 90 });
await writeFile('view.png', await scene.png({ width: 1280, height: 800 }));
scene.free();`;

export const inline = `<ray-caster label="A stone gate in a walled yard">
  <script type="application/json">
    {
      "title": "A gate",
      "textures": {
        "brick": "../textures/brick.png",
        "stone": "../textures/stone-blocks.png",
        "grass": "../textures/grass.png"
      },
      "blueprints": {
        "wall": { "faces": "brick" },
        "pillar": { "faces": "stone" },
        "beam": { "top": 0.5, "faces": "stone" }
      },
      "legend": { "#": "wall", "o": "pillar", "-": "beam" },
      "maps": [{
        "name": "yard",
        "floor": "grass",
        "sky": { "panorama": "../textures/sky-day.png" },
        "levels": [
          ["#########",
           "#.......#",
           "#..o.o..#",
           "#.......#",
           "#.......#",
           "#.......#",
           "#.......#",
           "#########"],
          [".........",
           ".........",
           "...---...",
           ".........",
           ".........",
           ".........",
           ".........",
           "........."]
        ]
      }],
      "start": { "x": 4.9, "y": 6.6, "heading": 262 }
    }
  </script>
</ray-caster>`;

export const ownRows = `<ray-caster view="2.2,9.4,1.7,312,-0.02" label="A keep on a terrace">
  <pre>
BBBBBBBBBBBBBB
B............B
B....aaaaa...B
B....aaaaa...B
B....aaaaa...B
B....aaaaa...B
B......1.....B
B............B
B.ggg......ggB
B.gGg..>...gGB
BBBBBBBBBBBBBB
---


     rrrrr
     rccr.
     rccrr
     rr.rr
---


     r r r

     r   r
     r   r
--- legend
a = sandstone
1 = sandstone 0.5
c = #c03020 0.6
g = #5d8a45 floor
G = hedge 0.8
  </pre>
</ray-caster>`;

export const objectScene = `<ray-caster id="plan" view="0.7,0.7,3.6,40,-0.45" label="Red and blue blocks"></ray-caster>
<ray-caster scene="#plan" view="10.3,7.3,3.6,220,-0.45" label="The same from the other side"></ray-caster>

<script type="module">
  document.getElementById('plan').scene = {
    rows: [['###########', '#>........#', '#..aa.bb..#', '#..a...b..#',
            '#.........#', '#...a.b...#', '#..aa.bb..#', '###########'],
           ['',            '',            '   aa bb',   '',
            '',            '',            '    a b']],
    legend: { a: '#c8462f', b: '#2f62b8', '#': '#8d8a80 0.4' },
    colours: true,
  };
</script>`;

export const live = [
  {
    title: 'A scene typed into the page',
    text: 'Rows of characters, seen from above, north at the top; the arrow is the start. The characters are explained below.',
    code: `<ray-caster view="1.6,7.6,0.7,338" label="A walled garden with a pond">
  <script type="text/plain" data-rows>
    HHHHHHHHHHHHHHHH
    H   t      T   H
    H  *...........P
    H   .~~~~~~~~..P
    H t .~~~~~~~~..O
    H   .~~~~~~~~..P
    H  i...........P
    H    >   *  t  H
    HHHHHHHHHHHHHHHH
  </script>
</ray-caster>`,
  },
  {
    title: 'The fish eye, an old way of drawing',
    text: 'Every setting of the engine is an option, even the flaws of old ways of drawing that the lessons show.',
    code: `<ray-caster scene="harbour-town"
            options="fov=110 method=classic classic.projection=equalAngles"
            label="A harbour town, bent as by a fish eye">
</ray-caster>`,
  },
  {
    title: 'What one slice meets',
    text: 'Overlays show the data of the renderer itself.',
    code: `<ray-caster scene="first-steps" size="960x600"
            overlay="minimap minimapRays inspector"
            label="A yard, its map with rays, and one slice from the side">
</ray-caster>`,
  },
  {
    title: 'Labels in the world',
    text: 'Children with data-at follow their place in the world and hide when it is covered. Here visitors can look around, but not walk.',
    code: `<ray-caster interaction="look" keys="move" label="Two towers in a yard">
  <pre>
#############
#...........#
#.......BB..#
#...........#
#.>.........#
#...........#
#.....RR....#
#...........#
#############
--- colours
  </pre>
  <a class="label" href="#shape-View" data-at="8,2.5,1">The brick tower</a>
  <a class="label" href="#shape-Hits" data-at="6,6.5,1.2">The rubble tower</a>
</ray-caster>`,
  },
  {
    title: 'Two views that move together',
    text: 'The same place, drawn exactly and in an old way. Turn one, and the other turns too.',
    code: `<ray-caster id="exact" scene="first-steps" size="480x300" controls="play reset"
            label="A yard"></ray-caster>
<ray-caster syncwith="#exact" scene="first-steps" size="480x300"
            options="method=classic classic.projection=equalAngles fov=110"
            label="The same yard, bent as by a fish eye"></ray-caster>`,
  },
  {
    title: 'Asked by a script',
    text: 'A page can ask what the picture shows: here, what the middle slice meets, and how far away.',
    code: `<ray-caster id="garden" scene="garden" controls label="A garden">
</ray-caster>
<pre id="met" tabindex="0"></pre>

<script type="module">
  const garden = document.getElementById('garden');
  const met = document.getElementById('met');
  const line = ({ depth, blueprint }) =>
    \`\${depth.toFixed(1).padStart(6)}  \${blueprint}\`;

  function tell() {
    const { hits } = garden.hits(Math.floor(garden.picture.width / 2));
    met.textContent = hits.map(line).join('\\n') || 'Nothing but sky';
  }
  garden.addEventListener('ready', tell);
  garden.addEventListener('viewchange', tell);
</script>`,
  },
];
