const NAMESPACE = 'http://www.w3.org/2000/svg';

/** Makes an element of an SVG picture. Attributes whose value is a function are listeners. */
export function svg(tag, attributes = {}, ...children) {
  const element = document.createElementNS(NAMESPACE, tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') element.addEventListener(name, value);
    else if (value !== null && value !== undefined && value !== false) element.setAttribute(name, value);
  }
  element.append(...children.filter(Boolean));
  return element;
}

/** A logarithmic scale from values between `low` and `high` to pixels. */
export function logScale(low, high, from, to) {
  const start = Math.log(low), share = (to - from) / (Math.log(high) - start);
  return (value) => from + (Math.log(value) - start) * share;
}
