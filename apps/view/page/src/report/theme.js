/** The value of a variable of the style sheet. */
export const styleOf = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

/** Calls `redraw` whenever the colours change: with the system's theme, and for printing, which is always light. */
export function onTheme(redraw) {
  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
  const set = (theme) => {
    document.documentElement.dataset.theme = theme;
    redraw();
  };
  window.addEventListener('beforeprint', () => set('light'));
  window.addEventListener('afterprint', () => set(''));
}
