/**
 * Makes an element. Attributes whose value is a function are listeners; children may be texts.
 * @returns {HTMLElement}
 */
export function el(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') element.addEventListener(name, value);
    else if (value === true) element.setAttribute(name, '');
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

/** Sets a text only where it differs, so that the browser does not lay out anew. */
export function setText(element, text) { if (element.textContent !== text) element.textContent = text; }

/** Whether the page is as narrow as on a phone. */
export const isNarrow = () => window.matchMedia('(max-width: 720px)').matches;
