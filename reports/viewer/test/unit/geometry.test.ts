import { describe, expect, it } from "vitest";
import type { Contact, Placed, Quat, Shape, Vec3 } from "../../src/data";
import { digits, length, ratio, share, short } from "../../src/format";
import { contactCentre } from "../../src/scene/contact_scene";
import { hull } from "../../src/scene/drawing";
import { makeCut } from "../../src/scene/section";
import { overlapAlong, support } from "../../src/scene/support";
import { add, dot, rotate, sub, times, unit } from "../../src/vector";

const turn: Quat = (() => { const q: Quat = [0.8, 0.1, -0.5, 0.3]; const s = Math.hypot(...q); return q.map((x) => x / s) as Quat; })();
const at: Vec3 = [0.3, -0.2, 0.7];
const bodies: Shape[] = [
  { type: "sphere", radius: 0.4 }, { type: "box", half: [0.5, 0.2, 0.3] }, { type: "capsule", radius: 0.2, length: 0.6 }, { type: "cylinder", radius: 0.3, length: 0.8 },
  { type: "cone", radius: 0.4, length: 0.9 }, { type: "hull", vertices: [[0.5, 0, 0], [-0.5, 0, 0], [0, 0.4, 0], [0, -0.4, 0], [0, 0, 0.6], [0, 0, -0.3]] },
];

describe.each(bodies.map((shape) => [shape.type, { shape, p: at, q: turn }] as [string, Placed]))("a %s", (_name, body) => {
  it("is cut by a line where the line enters and leaves, at support points too", () => {
    for (const d of [[1, 0, 0], [0, 0, 1], [0.3, -0.8, 0.5]] as Vec3[]) {
      const n = unit(d);
      const top = support(body, n)!;
      const inner = add(times(0.999, top), times(0.001, at));
      const part = makeCut(body, inner, n)([0, 0, 0]);
      expect(part).not.toBeNull();
      // Nothing of the body is beyond its support point.
      expect(part![1]).toBeLessThanOrEqual(dot(n, sub(top, inner)) + 1e-12);
      expect(part![0]).toBeLessThan(part![1]);
      expect(makeCut(body, add(top, times(1e-6, n)), [n[1], -n[0], 0])([0, 0, 0])).toBeNull();
    }
  });

  it("overlaps itself, moved by a little less than its width, and no longer beyond", () => {
    const n = unit([0.2, 0.5, -0.7]);
    const width = dot(n, sub(support(body, n)!, support(body, times(-1, n))!));
    expect(overlapAlong(body, { ...body, p: add(at, times(width - 0.01, n)) }, n)).toBeCloseTo(0.01, 12);
    expect(overlapAlong(body, { ...body, p: add(at, times(width + 0.01, n)) }, n)).toBeCloseTo(-0.01, 12);
  });
});

describe("a half-space", () => {
  const floor: Placed = { shape: { type: "half_space" }, p: [5, 5, 0], q: [1, 0, 0, 0] };
  it("ends along its normal only", () => {
    const ball: Placed = { shape: { type: "sphere", radius: 1 }, p: [0, 0, 0.9], q: [1, 0, 0, 0] };
    expect(overlapAlong(floor, ball, [0, 0, 1])).toBeCloseTo(0.1, 12);
    expect(overlapAlong(floor, ball, [0, 1, 0])).toBe(Infinity);
    expect(makeCut(floor, [0, 0, 0.5], [0, 0, 1])([0.1, 0, 0])).toEqual([-Infinity, -0.5]);
  });
});

describe("a section", () => {
  it("keeps a depth of 1e-12 m of a ball of 1 m, where single precision would have none", () => {
    const ball: Placed = { shape: { type: "sphere", radius: 1 }, p: [0, 0, 1 - 1e-12], q: [1, 0, 0, 0] };
    const part = makeCut(ball, [0, 0, 0], [0, 0, 1])([0, 0, 0])!;
    expect(Math.abs(part[0] + 1e-12)).toBeLessThan(2e-16);
  });
});

describe("formats", () => {
  // The program writes the same numbers into its sentences: tests/reports/clusters/clusters_test.cc has the same pairs.
  it("write a number as the program does", () => {
    expect([0.048, 0.0099999, 1.3e-5, 0.0021, 659.2, 2084, 99.7, 2e-16].map((x) => length(x))).toEqual(["4.8 cm", "1 cm", "13 µm", "2.1 mm", "659 m", "2080 m", "100 m", "2e-16 m"]);
    expect([0.05, 1.02, 4.03, 12, 2e-5, 2e-4, 1.8e6].map((x) => share(x, "it"))).toEqual(["5 % of it", "102 % of it", "4 times it", "12 times it", "2e-5 of it", "0.02 % of it", "1.8e6 times it"]);
    expect([short(-528.3), short(0.00094), short(9.4e-7), short(99.7), short(NaN)]).toEqual(["−528", "0.00094", "9.4e-7", "100", "not a number"]);
  });

  it("say lengths with a prefix that suits them, and shares in per cent", () => {
    expect([length(0.0481), length(1.3e-5), length(-2e-16), length(12), length(0)]).toEqual(["4.8 cm", "13 µm", "−2e-16 m", "12 m", "0 m"]);
    expect([ratio(0.05), ratio(2e-16), ratio(51), digits(NaN), digits(Infinity)]).toEqual(["5 %", "2e-16", "51 ×", "not a number", "∞"]);
  });
});

describe("the outline of projected corners", () => {
  it("is their convex hull", () => {
    expect(hull([[0, 0], [2, 0], [1, 1], [2, 2], [0, 2], [1, 0.5]])).toHaveLength(4);
    expect(rotate(turn, [0, 0, 0])).toEqual([0, 0, 0]);
  });
});

describe("the point around which a contact is drawn", () => {
  const box = (half: Vec3, p: Vec3): Placed => ({ shape: { type: "box", half }, p, q: [1, 0, 0, 0] });
  const contact = (A: Placed, B: Placed, n: Vec3): Contact => ({
    A, B, answers: [],
    truth: { touching: "touching", lo: 0, hi: 0, method: "", n, pA: support(A, n)!, pB: support(B, times(-1, n))!, patch: [] },
  });

  it("is at the small body, though the certificate names a far corner of the large one", () => {
    const c = contactCentre(contact(box([500, 500, 500], [0, 0, -500]), box([1e-4, 1e-4, 1e-4], [3, -4, 1e-4 - 1e-6]), [0, 0, 1]));
    expect(Math.hypot(c[0] - 3, c[1] + 4)).toBeLessThan(2e-4);
    expect(c[2]).toBeCloseTo(-5e-7, 9);
  });

  it("is the same with A and B exchanged", () => {
    const c = contactCentre(contact(box([1e-4, 1e-4, 1e-4], [3, -4, 1e-4 - 1e-6]), box([500, 500, 500], [0, 0, -500]), [0, 0, -1]));
    expect(Math.hypot(c[0] - 3, c[1] + 4)).toBeLessThan(2e-4);
  });

  it("is between the bodies where nothing is certified", () => {
    const none = contact(box([1, 1, 1], [0, 0, 0]), box([1, 1, 1], [4, 0, 0]), [0, 0, 0]);
    expect(contactCentre(none)).toEqual([2, 0, 0]);
  });
});
