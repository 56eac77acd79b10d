/** The rows of the tables that belong to settings. `pick` is called with the setting whose row was clicked. */
export function listenToRows(pick) {
  for (const row of document.querySelectorAll('tr[data-setting]')) {
    row.addEventListener('click', () => { if (getSelection().isCollapsed) pick(Number(row.dataset.setting), false); });
  }
}

/** Marks the rows of a setting; null for none. `goes`: the first one is brought into view. */
export function markRows(setting, goes) {
  let first = null;
  for (const row of document.querySelectorAll('tr[data-setting]')) {
    const isIt = Number(row.dataset.setting) === setting;
    row.classList.toggle('picked', isIt);
    if (isIt) first ??= row;
  }
  if (goes) first?.scrollIntoView({ block: 'center', behavior: matchMedia('(prefers-reduced-motion: reduce)').matches ? 'auto' : 'smooth' });
}
