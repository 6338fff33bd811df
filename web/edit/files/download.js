// Gives a file to the visitor: into the folder of downloads.
//
//     download('yard.json', bytes, 'application/json');

const kPatience = 60_000; // milliseconds: the browser may ask where to

export function download(name, content, type) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), kPatience);
}
