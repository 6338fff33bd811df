// The addresses of the three lessons that came before the tutorial, each of which leads to the
// chapter that replaced it.

import { mkdir, writeFile } from 'node:fs/promises';
import path from 'node:path';

const kMoved = {
  'index.html': 'index.html',
  'one-ray.html': 'one-ray.html',
  'walls-and-floor.html': 'from-depth-to-height.html',
  'heights-and-hits.html': 'heights.html',
};

export async function writeRedirects(folder) {
  await mkdir(path.join(folder, 'examples'), { recursive: true });
  for (const [from, to] of Object.entries(kMoved)) {
    const address = `../learn/${to}`;
    const page = `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>This lesson has moved</title>
<meta name="robots" content="noindex">
<meta http-equiv="refresh" content="0; url=${address}">
<link rel="canonical" href="${address}">
<link rel="icon" href="../favicon.svg" type="image/svg+xml">
</head>
<body><p>This lesson is now <a href="${address}">a chapter of the tutorial</a>.</p></body>
</html>
`;
    await writeFile(path.join(folder, 'examples', from), page);
  }
}
