/** Finds places for short labels at the marks of a plot, so that they cover neither each other nor a mark, and few bars. */

const LETTER = 7.5, HEIGHT = 13, MARK = 6, GAP = 5;
/** Distances of a label's middle from its mark [pixels], and directions around it, those to be preferred first. */
const RINGS = [13, 19, 27, 37, 50], DIRECTIONS = [-40, 40, 0, -90, 90, 180, -140, 140, -65, 65, -115, 115];
const PER_AREA = 10, PER_BAR_AREA = 1, PER_PIXEL_OFF = 1.5, OUTSIDE = 1e4;

const boxAt = (x, y, width, height) => ({ left: x - width / 2, right: x + width / 2, top: y - height / 2, bottom: y + height / 2 });

function overlap(a, b) {
  const wide = Math.min(a.right, b.right) - Math.max(a.left, b.left), high = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
  return wide > 0 && high > 0 ? wide * high : 0;
}

/**
 * @param {{x: number, y: number, radius?: number, text: string, bars: object[]}[]} marks in pixels, the most important ones first;
 * `bars` are boxes
 * @param {{left: number, right: number, top: number, bottom: number}} frame
 * @returns {{x: number, y: number, isFar: boolean, end: number[], box: object}[]} the middle of each label; `isFar`: it needs a
 * line from its mark to `end`
 */
export function placeLabels(marks, frame) {
  const around = marks.map(({ x, y, radius = MARK }) => boxAt(x, y, 2 * radius, 2 * radius)), bars = marks.flatMap((mark) => mark.bars), placed = [];
  const sum = (box, others) => others.reduce((area, other) => area + overlap(box, other), 0);
  for (const { x, y, text, radius = MARK } of marks) {
    let best = null;
    for (const ring of RINGS) {
      for (const direction of DIRECTIONS) {
        const angle = direction * Math.PI / 180, at = [x + ring * Math.cos(angle), y + ring * Math.sin(angle)];
        const box = boxAt(at[0], at[1], LETTER * text.length + GAP, HEIGHT);
        const isOutside = box.left < frame.left || box.right > frame.right || box.top < frame.top || box.bottom > frame.bottom;
        const covered = sum(box, around) + sum(box, placed.map((label) => label.box));
        const cost = PER_AREA * covered + PER_BAR_AREA * sum(box, bars) + PER_PIXEL_OFF * ring + (isOutside ? OUTSIDE : 0);
        const end = [x + (ring - RINGS[0] + 4) * Math.cos(angle), y + (ring - RINGS[0] + 4) * Math.sin(angle)];
        if (!best || cost < best.cost) best = { x: at[0], y: at[1], box, cost, end, isFar: ring > RINGS[1] + 2 * (radius - MARK) };
      }
    }
    placed.push(best);
  }
  return placed;
}
