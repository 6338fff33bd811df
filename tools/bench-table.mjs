// The tables of tools/bench, at most 120 characters wide: a row per view, a group of columns per
// build.
//
//     table(runs)            the time of each view
//     phasesTable(runs)      the time of each phase of a frame
//     againstTable(pairs)    the times of two builds of the same kind
//     slowestTable(moments)  the slowest moments of the tours
//
// A run is the output of slicecast-bench with its build's `title`, and of each view the `title`,
// its `ratio` to the limit, and what is asked of that, `most`.

const kNameWidth = 32;

const share = (number) => `${Math.round(number * 100)} %`;

// [heading, width, what it shows of a row of figures]; both end at the right
const kColumns = [
  ['ns/px', 8, (of) => of.nsPerPixel.toFixed(of.nsPerPixel < 1 ? 3 : 2)],
  ['spread', 8, (of) => share(of.spread)],
  ['limit ', 8, (of) => (of.ratio ? of.ratio.toFixed(2) + (of.ratio > of.most ? '!' : ' ') : '')],
  ['asked', 7, (of) => (of.most < Infinity ? of.most.toFixed(2) : '')],
  ['walk', 6, (of) => (of.phases ? share(of.walkShare) : '')],
  ['replay', 7, (of) => of.replay?.toFixed(2) ?? ''],
];

const kPhaseColumns = [
  ['draw', 8, (of) => of.nsPerPixel.toFixed(3)],
  ...['setUp', 'walk', 'paint', 'copy'].map((phase) => [
    phase,
    7,
    (of) => of.phases[phase].toFixed(3),
  ]),
];

const kAgainstColumns = [
  ['that', 8, ({ that }) => that.toFixed(2)],
  ['this', 8, (of) => of.here.toFixed(2)],
  ['change', 8, ({ that, here }) => `${(100 * (here / that - 1)).toFixed(1)} %`],
];

// `rows`: [name, the figures of each group]
function lines(columns, titles, rows) {
  const line = (name, groups) => (name.padEnd(kNameWidth) + groups.join('')).trimEnd();
  const width = columns.reduce((sum, [, wide]) => sum + wide, 0);
  const head = columns.map(([heading, wide]) => heading.padStart(wide)).join('');
  return [
    line(
      '',
      titles.map((title) => `  ${title}`.padEnd(width)),
    ),
    line(
      '',
      titles.map(() => head),
    ),
    ...rows.map(([name, figures]) =>
      line(
        name,
        figures.map((of) => columns.map(([, wide, show]) => show(of).padStart(wide)).join('')),
      ),
    ),
  ];
}

const titlesOf = (runs) => runs.map(({ title }) => title);
const viewRows = (runs) =>
  runs[0].views.map(({ title }, index) => [title, runs.map(({ views }) => views[index])]);

export function table(runs) {
  const [{ width, height, rounds }] = runs;
  return [
    ...lines(kColumns, titlesOf(runs), [
      ['copy of a frame', runs.map(({ copy }) => copy)],
      ['the limit', runs.map(({ limit }) => limit)],
      ...viewRows(runs),
    ]),
    '',
    `ns/px   nanoseconds a pixel of ${width}x${height}, the least of ${rounds} rounds`,
    'spread  how much longer the middle round took: other programs disturbed',
    'limit   times the limit, a frame as full without a world; ! above what is asked',
    "walk    the walk's share of the time",
    'replay  the same spans painted without a walk, times the limit: a bound for any faster walk',
  ].join('\n');
}

export const phasesTable = (runs) =>
  [...lines(kPhaseColumns, titlesOf(runs), viewRows(runs)), '', 'Nanoseconds a pixel.'].join('\n');

// `pairs`: [a run of the other build, one of this], for each kind of build
export const againstTable = (pairs) =>
  [
    ...lines(
      kAgainstColumns,
      pairs.map(([{ title }]) => title),
      pairs[0][0].views.map(({ title }, index) => [
        title,
        pairs.map((pair) => {
          const [that, here] = pair.map(({ views }) => views[index].nsPerPixel);
          return { that, here };
        }),
      ]),
    ),
    '',
    'Nanoseconds a pixel, the least of all rounds.',
  ].join('\n');

export function slowestTable(moments) {
  const head = `${'scene'.padEnd(15)}${'step'.padStart(6)}  ns/px  where`;
  return [
    head,
    ...moments.map(
      ({ scene, step, map, x, y, z, heading, nsPerPixel }) =>
        `${scene.padEnd(15)}${String(step).padStart(6)}${nsPerPixel.toFixed(2).padStart(7)}  ` +
        `${map} ${x}, ${y}, ${z}, heading ${heading}`,
    ),
  ].join('\n');
}
