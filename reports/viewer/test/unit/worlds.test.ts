import { describe, expect, it } from "vitest";
import type { Question, Vec3, World } from "../../src/data";
import { lawName, withoutPlace } from "../../src/expectation";
import { tickLabels } from "../../src/plots";
import { proofClause } from "../../src/proof_clause";
import { causeOf } from "../../src/responsible";
import type { Run } from "../../src/run";
import { groundGrid, makeDropLines } from "../../src/scene/ground";
import { formOf } from "../../src/scene/shapes";
import * as three from "three";

describe("an expectation", () => {
  const question = { toml: `id = "x"
[bodies.thrown]
velocity = [1, 0, 0]

[[expect]]
body = "thrown"
at = 0.4
velocity = [-40.0, 0.0, 0.0]
because = "at = 3"

[[expect]]
body = 'mote'
by = 1.50
topples = false

[[expect]]
body = "ball"
touches = "wall"
at = 0.5

[[claims]]
law = "stable"
` } as Question;
  it("is named after what it expects, not by its place in the file", () => {
    expect(lawName(question, "expect[0]")).toBe("expected of thrown at 0.4 s");
    expect(lawName(question, "expect[1]")).toBe("expected of mote: does not topple by 1.5 s");
    expect(lawName(question, "expect[2]")).toBe("expected of ball: touches wall at 0.5 s");
    expect(lawName(question, "expect[3]")).toBe("expect[3]");
    expect(lawName(question, "slide_to_stop")).toBe("slide to stop");
    expect(withoutPlace("expect[0]: “thrown” is expected")).toBe("“thrown” is expected");
  });
});

describe("a logarithmic axis", () => {
  const ticks = (low: number, high: number): number[] => Array.from({ length: high - low + 1 }, (_, d) => Array.from({ length: 9 }, (_u, k) => (k + 1) * 10 ** (low + d))).flat();
  it("has labels at decades, however many there are, and none twice", () => {
    for (const [low, high] of [[0, 3], [-2, 8], [-300, 300]]) {
      const labels = tickLabels(ticks(low, high), true, "m").filter((label) => label !== "");
      expect(labels.length).toBeGreaterThanOrEqual(3);
      expect(labels.length).toBeLessThanOrEqual(8);
      expect(new Set(labels).size).toBe(labels.length);
    }
  });
});

describe("a clause of a proof", () => {
  it("tells numbers apart that are written in two ways", () => {
    expect(proofClause("fcl says 0.00099999953 m deep; no translation shorter than 0.001 m separates them")).toBe("fcl says 9.999995e-4 m deep; no translation shorter than 0.001 m separates them");
  });
});

describe("the cause of a finding", () => {
  const run = (responsible: string | undefined, cause: number): Run => ({
    text: () => "it stays at smaller steps",
    report: { clusters: [], ledger: [{ responsible }], names: { cause: ["", "model", "defect", "setting"] }, findings: { ledger: [0], cluster: [-1], cause: [cause], cause_because: [0] } },
  } as unknown as Run);
  it("is one verdict: what the ledger says, and what was measured apart from it", () => {
    expect(causeOf(run("model", 2), 0)).toMatchObject({ verdict: "documented model", measured: "it stays at smaller steps" });
    expect(causeOf(run("adapter", 2), 0).verdict).toBe("our setting");
    expect(causeOf(run("engine", 2), 0)).toMatchObject({ verdict: "defect", meaning: "" });
    expect(causeOf(run("engine", 1), 0).verdict).toBe("documented model");
    expect(causeOf(run("engine", 3), 0).verdict).toBe("our setting");
  });
});

describe("the ground of a world", () => {
  const box = (p: Vec3, half: Vec3, fixed: boolean, name: string) => ({ name, fixed, shape: { type: "box" as const, half }, start: { p, q: [1, 0, 0, 0] as [number, number, number, number] } });
  const floor = { name: "floor", fixed: true, shape: { type: "half_space" as const }, start: { p: [0, 0, 0] as Vec3, q: [1, 0, 0, 0] as [number, number, number, number] } };
  const world = { bodies: [floor, box([5, 0, 0.5], [1, 1, 0.5], true, "table"), box([0, 0, 4], [0.5, 0.5, 0.5], false, "cube")] } as unknown as World;
  const frame = { centre: [0, 0, 0] as Vec3, scale: 1 };
  const ends = (place: Vec3): number[] => {
    const drops = makeDropLines(world, frame, [0, 0, 1], "#000000");
    drops.set([null, null, place]);
    const points = drops.lines.geometry.getAttribute("position");
    return points && points.count > 0 ? [points.getZ(0), points.getZ(1)] : [];
  };
  it("is the end of a line from a body in the air, and of none from one that may touch it", () => {
    expect(ends([0, 0, 4])).toEqual([4, 0]);
    expect(ends([5.5, 0, 4])).toEqual([4, 1]);
    expect(ends([0, 0, 0.5])).toEqual([]);
  });
  it("has a grid with about as many squares in every view", () => {
    for (const radius of [1e-3, 0.2, 1]) {
      const points = groundGrid(world, frame, new three.Vector3(0.3, 0, 0), radius, "#000000")!.geometry.getAttribute("position");
      const spacing = Math.abs(points.getX(4) - points.getX(0));
      expect(radius / spacing).toBeGreaterThan(1.5);
      expect(radius / spacing).toBeLessThan(8);
    }
    expect(groundGrid({ bodies: [world.bodies[2]] } as unknown as World, frame, new three.Vector3(), 1, "#000000")).toBeNull();
  });
});

describe("a ball", () => {
  it("has two tones, so that it is seen to turn", () => {
    const tones = formOf({ type: "sphere", radius: 1 }, 1, 1).surface.getAttribute("color");
    const values = new Set(Array.from({ length: tones.count }, (_, i) => tones.getX(i)));
    expect(values.size).toBe(2);
  });
});
