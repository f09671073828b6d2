import { describe, expect, it } from "vitest";
import type { Report } from "../../src/data";
import { contactVariant, makeCited, makeProofs, makeStudies, worldVariant } from "../../src/proofs";

const report = (more: object): Report => ({
  texts: ["swap: A and B exchanged", "lid"],
  names: { proof: ["", "plane", "common point", "variant normal", "variant separation", "places"], claim: ["", "touching"] },
  ...more,
}) as unknown as Report;
const row = { finding: [7], kind: [0], claim: [0], said: [null], bound: [null], n: [null], offset: [null], claimed: [null], points: [[]], change: [-1], body: [-1], time: [null] };
const proofOf = (columns: object) => makeProofs(report({ proofs: { ...row, ...columns } }))(7);

describe("a proof", () => {
  it("has the numbers of its row", () => {
    expect(proofOf({ kind: [1], claim: [1], bound: [0.25], n: [[0, 0, 1]], offset: [1.5] }))
      .toMatchObject({ kind: "plane", claim: "touching", said: NaN, bound: 0.25, n: [0, 0, 1], offset: 1.5, claimed: null, points: [] });
    expect(makeProofs(report({ proofs: row }))(6)).toBeNull();
    expect(makeProofs(report({}))(7)).toBeNull();
  });

  it("gives the normal of a variant, or its separation", () => {
    expect(contactVariant(proofOf({ kind: [3], n: [[0, 1, 0]], bound: [1.5], change: [0] }))).toEqual({ name: "swap", how: "A and B exchanged", n: [0, 1, 0], separation: NaN });
    expect(contactVariant(proofOf({ kind: [4], bound: [-0.5], change: [0] }))).toEqual({ name: "swap", how: "A and B exchanged", n: null, separation: -0.5 });
    expect(contactVariant(proofOf({ kind: [1] }))).toBeNull();
  });

  it("gives the two places of a body", () => {
    expect(worldVariant(proofOf({ kind: [5], points: [[[1, 2, 3], [4, 5, 6]]], body: [1], time: [0.5] }))).toEqual({ time: 0.5, body: "lid", own: [1, 2, 3], variant: [4, 5, 6] });
    expect(worldVariant(proofOf({ kind: [5], points: [[[1, 2, 3]]], body: [1], time: [0.5] }))).toBeNull();
    expect(worldVariant(proofOf({ kind: [5], points: [[[1, 2, 3], [4, 5, 6]]], time: [null] }))).toBeNull();
  });

  it("of damaged data has no direction and no point", () => {
    for (const bad of [["x", 0, 1], [1, 2], {}, "n", [NaN, 0, 0]]) expect(proofOf({ kind: [99], n: [bad], points: [[bad]] })).toMatchObject({ kind: "", n: null, points: [] });
    expect(makeProofs(report({ proofs: { finding: [7] } }))(7)).toMatchObject({ kind: "", points: [], change: "" });
  });
});

describe("what a proof names", () => {
  it("is the bodies and the points of its row, in their order", () => {
    const cited = makeCited(report({ cited: { finding: [3, 5], bodies: [[2, 0], []], points: [[], [[1, 2, 3], [4, 5, 6]]] } }));
    expect(cited(3)).toEqual({ bodies: [2, 0], points: [] });
    expect(cited(5)).toEqual({ bodies: [], points: [[1, 2, 3], [4, 5, 6]] });
    expect(cited(4)).toEqual({ bodies: [], points: [] });
  });

  it("is nothing in damaged data, and in those of programs that do not say it", () => {
    expect(makeCited(report({}))(3)).toEqual({ bodies: [], points: [] });
    expect(makeCited(report({ cited: { finding: [3], bodies: ["box"], points: [[[1, 2], "x", [1, 2, NaN]]] } }))(3)).toEqual({ bodies: [], points: [] });
    expect(makeCited(report({ cited: { finding: [3], bodies: [[0.5, "1", 1]], points: [null] } }))(3)).toEqual({ bodies: [1], points: [] });
  });
});

describe("a step study", () => {
  it("has three errors and their unit", () => {
    const study = makeStudies(report({ studies: { finding: [3, 4], errors: [[3, 2, 1], [1, "nan", 2]], unit: ["N", "m"] } }));
    expect(study(3)).toEqual({ errors: [3, 2, 1], unit: "N" });
    expect([study(4), study(5), makeStudies(report({}))(3)]).toEqual([null, null, null]);
  });
});
