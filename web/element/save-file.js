// Saves a blob as a file, like a download.
//
//     saveFile('castle.png', blob);

const kKeepMilliseconds = 10000; // by then the browser has surely begun to read the blob

export function saveFile(name, blob) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), kKeepMilliseconds);
}
