// What pages to read do: each snippet of code has a button that copies it. Without this file they are read
// all the same.

const kSaysSoMilliseconds = 2000;

for (const snippet of document.querySelectorAll('.snippet:not(.drawing)')) {
  const button = document.createElement('button');
  button.type = 'button';
  button.textContent = 'Copy';
  button.addEventListener('click', async () => {
    const isCopied = await copy(snippet.querySelector('code').textContent);
    button.textContent = isCopied ? 'Copied' : 'Not allowed';
    setTimeout(() => {
      button.textContent = 'Copy';
    }, kSaysSoMilliseconds);
  });
  snippet.append(button);
}

// A link to a shape opens it.
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
