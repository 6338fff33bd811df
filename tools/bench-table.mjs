// The tables of tools/bench, 120 characters wide: a row per view, a group of columns per build.
//
//     table(runs)            the time of each view
//     phasesTable(runs)      the time of each phase of a frame
//
// A run is the output of slicecast-bench, with the build's `title`, and `missed`, the titles of the
// views that miss their target.

const kNameWidth = 32;

const ratio = (number) => number?.toFixed(2) ?? '';
const share = (number) => (number === undefined ? '' : `${Math.round(number * 100)} %`);

// [heading, width, what it shows of a row of figures]; both end at the right
const kColumns = [
  ['ns/px', 8, (of) => of.nsPerPixel.toFixed(of.nsPerPixel < 1 ? 3 : 2)],
  ['spread', 8, (of) => `±${share(of.spread / 2).padStart(4)}`],
  ['limit ', 8, (of) => ratio(of.limits) + (of.isMissed ? '!' : ' ')],
  ['walk', 6, (of) => share(of.walkShare)],
  ['replay', 7, (of) => ratio(of.replay)],
  ['4K', 6, (of) => ratio(of.large?.ratio)],
];

const sumOf = ({ setUp, walk, paint, copy }) => setUp + walk + paint + copy;
const kPhaseColumns = [
  ['draw', 8, (of) => of.nsPerPixel.toFixed(3)],
  ['set-up', 7, (of) => of.phases.setUp.toFixed(3)],
  ['walk', 7, (of) => of.phases.walk.toFixed(3)],
  ['paint', 7, (of) => of.phases.paint.toFixed(3)],
  ['copy', 7, (of) => of.phases.copy.toFixed(3)],
  ['sum', 7, (of) => share(sumOf(of.phases) / of.nsPerPixel)],
];

// `rows`: [name, the figures of each run]
function lines(columns, runs, rows) {
  const line = (name, groups) => (name.padEnd(kNameWidth) + groups.join('')).trimEnd();
  const width = columns.reduce((sum, [, wide]) => sum + wide, 0);
  const head = columns.map(([heading, wide]) => heading.padStart(wide)).join('');
  return [
    line(
      '',
      runs.map(({ title }) => `  ${title}`.padEnd(width)),
    ),
    line(
      '',
      runs.map(() => head),
    ),
    ...rows.map(([name, figures]) =>
      line(
        name,
        figures.map((of) => columns.map(([, wide, show]) => show(of).padStart(wide)).join('')),
      ),
    ),
  ];
}

const viewRows = (runs) =>
  runs[0].views.map(({ title }, index) => [
    title,
    runs.map((run) => ({
      ...run.views[index],
      limits: run.views[index].ratio,
      isMissed: run.missed.includes(title),
    })),
  ]);

export function table(runs) {
  const [{ width, height, rounds, limit }] = runs;
  const large = `${limit.large.width}x${limit.large.height}`;
  return [
    ...lines(kColumns, runs, [
      ['copy of a frame', runs.map(({ copy }) => copy)],
      ['the limit', runs.map((run) => ({ ...run.limit, large: undefined }))],
      [`the limit at ${large}`, runs.map((run) => run.limit.large)],
      ...viewRows(runs),
    ]),
    '',
    `ns/px   nanoseconds a pixel of ${width}x${height}, medians of ${rounds} rounds`,
    'spread  half the range of the middle half of the rounds',
    'limit   times the limit, which is a frame as full without a world; ! above the target',
    "walk    the walk's share of the time",
    'replay  the same spans painted without a walk, times the limit: a bound for any faster walk',
    `4K      the view at ${large}, times the limit at that size`,
  ].join('\n');
}

export function phasesTable(runs) {
  return [...lines(kPhaseColumns, runs, viewRows(runs)), '', 'Nanoseconds a pixel.'].join('\n');
}
