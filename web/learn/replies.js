// Checks the answers that readers type under exercises. The right number, computed when the page
// was built, is in the form's data-answer, and how far off it may be in data-tolerance.

export function startReplies(root) {
  for (const form of root.querySelectorAll('form.reply')) {
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      const output = form.querySelector('output');
      const { kind, text } = judge(form.querySelector('input').value, form.dataset);
      output.className = kind;
      output.textContent = text;
    });
  }
}

// What to say to an answer: {kind: 'right', 'false' or '', text}.
export function judge(written, { answer, tolerance }) {
  const plain = written.trim().replace(',', '.').replace('−', '-');
  const value = Number(plain);
  if (plain === '' || !Number.isFinite(value)) return { kind: '', text: 'Type a number.' };
  const error = value - Number(answer);
  if (Math.abs(error) <= Number(tolerance)) return { kind: 'right', text: '✓ Right.' };
  return { kind: 'false', text: `✗ Not yet: ${value} is too ${error > 0 ? 'large' : 'small'}.` };
}
