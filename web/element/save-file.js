// Hands something to the browser as a file to keep.
//
//     saveFile('castle.png', blob);

const kKeepMilliseconds = 10000; // until the browser has surely begun to read it

export function saveFile(name, blob) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), kKeepMilliseconds);
}
