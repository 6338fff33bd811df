// Small questions in the page: a name, or whether to go on.
// Takes words; gives answers. Knows no document.
//
//     await askName('Save as a stamp', 'gate house')            // a name, or null
//     await askWhether('Remove the map', ['It has 3 portals.'], 'Remove')   // true or false

export async function askName(title, name) {
  const input = document.createElement('input');
  input.value = name;
  input.maxLength = 100;
  input.required = true;
  input.setAttribute('aria-label', 'Name');
  const isSure = await ask(title, [input], 'Save');
  const answer = input.value.trim();
  return isSure && answer !== '' ? answer : null;
}

export function askWhether(title, told, label) {
  const lines = told.map((text) => {
    const line = document.createElement('p');
    line.textContent = text;
    return line;
  });
  return ask(title, lines, label);
}

// A dialog with a form; true if it was agreed to.
export function ask(title, parts, label) {
  const dialog = document.createElement('dialog');
  dialog.className = 'small';
  const form = document.createElement('form');
  form.method = 'dialog';
  const heading = document.createElement('h2');
  heading.textContent = title;
  dialog.setAttribute('aria-label', title);
  const buttons = document.createElement('p');
  buttons.className = 'row end';
  for (const [text, value] of [
    ['Cancel', ''],
    [label, 'yes'],
  ]) {
    const button = document.createElement('button');
    button.type = value === '' ? 'button' : 'submit';
    button.value = value;
    button.textContent = text;
    if (value === '') button.addEventListener('click', () => dialog.close(''));
    else button.className = 'main';
    buttons.append(button);
  }
  form.append(heading, ...parts, buttons);
  dialog.append(form);
  document.body.append(dialog);
  dialog.showModal();
  form.querySelector('input, select')?.select?.();
  return new Promise((resolve) => {
    dialog.addEventListener('close', () => {
      dialog.remove();
      resolve(dialog.returnValue === 'yes');
    });
  });
}
