/** A label in a view: where its left upper corner would be, and its size [px]. */
export interface LabelBox { x: number; y: number; width: number; height: number }

export const overlap = (a: LabelBox, b: LabelBox): boolean => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

/** Moves labels that would cover an earlier one to the nearest free place below, above or beside it. Returns the shift of each [px]. */
export function separateLabels(boxes: LabelBox[]): [number, number][] {
  const placed: LabelBox[] = [];
  return boxes.map((box) => {
    const { width: w, height: h } = box;
    const beside = placed.flatMap((other): [number, number][] => [[other.x + other.width - box.x, 0], [other.x - w - box.x, 0]]);
    const shifts: [number, number][] = [[0, 0], [0, h], [0, -h], [0, 2 * h], [0, -2 * h], [w, h], [-w, -h], ...beside];
    shifts.sort(([ax, ay], [bx, by]) => Math.abs(ax) + Math.abs(ay) - Math.abs(bx) - Math.abs(by));
    const isFree = ([dx, dy]: [number, number]): boolean => !placed.some((other) => overlap(other, { ...box, x: box.x + dx, y: box.y + dy }));
    const shift = shifts.find(isFree) ?? [0, 0];
    placed.push({ ...box, x: box.x + shift[0], y: box.y + shift[1] });
    return shift;
  });
}
