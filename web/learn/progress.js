// Remembers in which chapters the reader's raycaster has passed all checks, and marks these in
// lists. Without storage nothing is marked.

const kKey = 'slicecast.learn.solved';

export function startProgress() {
  mark();
  document.addEventListener('write-solved', ({ detail: { chapter } }) => {
    const solved = new Set([...read(), chapter]);
    try {
      localStorage.setItem(kKey, JSON.stringify([...solved].sort((a, b) => a - b)));
    } catch {
      // Storage is full or forbidden.
    }
    mark();
  });
}

function read() {
  try {
    const list = JSON.parse(localStorage.getItem(kKey) ?? '[]');
    return Array.isArray(list) ? list.filter(Number.isInteger) : [];
  } catch {
    return [];
  }
}

function mark() {
  const solved = new Set(read());
  for (const item of document.querySelectorAll('.chapters li, .cards li')) {
    if (!solved.has(item.value) || item.classList.contains('solved')) continue;
    item.classList.add('solved');
    const words = document.createElement('span');
    words.className = 'solved-mark';
    words.textContent = '✓ Your raycaster passes';
    item.querySelector('a').append(words);
  }
}
