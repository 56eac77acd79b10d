const SHOWN_MS = 1500;

/** Copies by the clipboard, or where a browser refuses that to a file, by a selection. */
async function copy(text, code) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    getSelection().selectAllChildren(code);
    return document.execCommand('copy');
  }
}

/** Gives each command of the page its button. */
export function addCopyButtons() {
  for (const box of document.querySelectorAll('.command')) {
    const code = box.querySelector('code'), button = box.querySelector('button');
    button.hidden = false;
    button.addEventListener('click', async () => {
      const isDone = await copy(code.textContent, code);
      button.textContent = isDone ? 'Copied' : 'Press Ctrl+C';
      setTimeout(() => { button.textContent = 'Copy'; }, SHOWN_MS);
    });
  }
}
