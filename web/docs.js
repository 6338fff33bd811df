// For the documentation pages: adds a copy button to each snippet of code and each path.

const kCopiedMilliseconds = 2000; // how long the button says "Copied"

for (const snippet of document.querySelectorAll('.snippet:not(.drawing), .path')) {
  const button = document.createElement('button');
  button.type = 'button';
  button.textContent = 'Copy';
  button.addEventListener('click', async () => {
    const isCopied = await copy(snippet.querySelector('code').textContent);
    button.textContent = isCopied ? 'Copied' : 'Not allowed';
    setTimeout(() => {
      button.textContent = 'Copy';
    }, kCopiedMilliseconds);
  });
  snippet.append(button);
}

// A link to a folded section opens it.
function openTarget() {
  const target = document.getElementById(location.hash.slice(1));
  if (target instanceof HTMLDetailsElement) target.open = true;
}
addEventListener('hashchange', openTarget);
openTarget();

async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}
