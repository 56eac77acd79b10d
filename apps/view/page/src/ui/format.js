/** Numbers, units and names as texts. */

const PREFIXES = [[1e9, 'G'], [1e6, 'M'], [1e3, 'k'], [1, '']];
const SCALED_UNITS = new Set(['N', 'Nm', 'J', 'W', 'Pa', 'Ns', 'Nms']);
const SHOWN_UNITS = { m_s: 'm/s', rad_s: 'rad/s', deg_s: '°/s', deg: '°', Nm: 'N m', Ns: 'N s', Nms: 'N m s', m3_s: 'm³/s',
                      sqrtJ: '√J' };

/** A number with three significant digits. */
export function formatNumber(value) {
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (Number.isInteger(value) && size < 1e6) return String(value);
  if (size >= 1e6 || size < 1e-3) return value.toExponential(1).replace('e+', 'e');
  if (size >= 1000) return String(Math.round(value));
  return value.toFixed(size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3);
}

/** A round number, such as that of a tick, without zeros at its end. */
export function formatRound(value) {
  const size = Math.abs(value);
  return size >= 1e6 || (size > 0 && size < 1e-3) ? Number(value.toPrecision(3)).toExponential().replace('e+', 'e') : String(Number(value.toPrecision(6)));
}

/** The factor and the text of a unit that suit values up to `size`: [1e-3, 'kN'] for 1e4 N. */
export function unitFor(size, unit) {
  const shown = SHOWN_UNITS[unit] ?? unit;
  if (!SCALED_UNITS.has(unit)) return [1, shown];
  for (const [factor, prefix] of PREFIXES) if (size >= factor) return [1 / factor, prefix + shown];
  return [1, shown];
}

/** A value with its unit. */
export function formatValue(value, unit) {
  if (!Number.isFinite(value)) return formatNumber(value);
  const [factor, text] = unitFor(Math.abs(value), unit);
  return text ? `${formatNumber(value * factor)} ${text}` : formatNumber(value);
}

/** A mass [kg] in kg or t. */
export function formatMass(mass) { return mass >= 1000 ? `${formatNumber(mass / 1000)} t` : `${formatNumber(mass)} kg`; }

/** A length [m] in mm or m. */
export function formatLength(length) { return length < 0.1 ? `${formatNumber(1000 * length)} mm` : `${formatNumber(length)} m`; }

/** A time [s] with as many digits as frames need. */
export function formatTime(time, every) { return time.toFixed(every >= 1 ? 0 : Math.min(3, Math.ceil(-Math.log10(every) - 1e-9))); }

/** Names that do not say what a channel is. Contacts of a step are points, those between floes of a frame are pairs. */
const TITLES = { contacts: 'Contact points', ice_resistance: 'Ice resistance, + astern', ice_side: 'Ice side, + to port' };

/** The name of a channel for readers: `work_drag` becomes `Work drag`, `contact_fx` becomes `Contact Fx`. */
export function channelTitle(name) {
  if (TITLES[name]) return TITLES[name];
  const text = name.replaceAll('_', ' ').replace(/\b([fm])([xyz])\b/g, (_, kind, axis) => kind.toUpperCase() + axis);
  return text.charAt(0).toUpperCase() + text.slice(1);
}
