// The map of the chapters: each stands to the right of those that it builds on, and lines lead to
// it from them. Drawn when the site is built, for wide windows; the list below it says the same.
//
//     chapterMap([{ number, name, title, needs }]);      // SVG

const kColumn = 84; // CSS pixels between chapters
const kRow = 64;
const kRadius = 20;
const kMargin = 28;

export function chapterMap(chapters) {
  const places = placesOf(chapters);
  const at = (name) => {
    const [column, row] = places.get(name);
    return [kMargin + kColumn * column, kMargin + kRow * row];
  };
  const columns = Math.max(...[...places.values()].map(([column]) => column));
  const rows = Math.max(...[...places.values()].map(([, row]) => row));
  const width = 2 * kMargin + kColumn * columns;
  const height = 2 * kMargin + kRow * rows;

  const lines = chapters.flatMap(({ name, needs }) =>
    needs.map((from) => {
      const [[x1, y1], [x2, y2]] = [at(from), at(name)];
      const bend = (x1 + x2) / 2;
      return `<path d="M${x1} ${y1}C${bend} ${y1} ${bend} ${y2} ${x2} ${y2}"/>`;
    }),
  );
  const dots = chapters.map(({ number, name, title }) => {
    const [x, y] = at(name);
    return (
      `<a href="${name}.html"><title>${title}</title><circle cx="${x}" cy="${y}" r="${kRadius}"/>` +
      `<text x="${x}" y="${y + 6}" text-anchor="middle">${number}</text></a>`
    );
  });
  return (
    `<svg class="chapter-map" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" ` +
    `role="group" aria-label="The chapters and what they build on">${lines.join('')}${dots.join('')}</svg>`
  );
}

// {name -> [column, row]}: a chapter's column is one more than that of the last chapter that it
// builds on; its row is that of the chapter on which it builds first, if it is free there.
function placesOf(chapters) {
  const places = new Map();
  const taken = new Set();
  for (const { name, needs } of chapters) {
    const before = needs.map((need) => places.get(need));
    const column = before.length === 0 ? 0 : 1 + Math.max(...before.map(([x]) => x));
    const wanted = before.length === 0 ? 0 : before[0][1];
    const rows = [0, 1, -1, 2, -2, 3, -3, 4, -4, 5].map((step) => wanted + step);
    const row = rows.find((each) => each >= 0 && !taken.has(`${column},${each}`));
    taken.add(`${column},${row}`);
    places.set(name, [column, row]);
  }
  return places;
}
