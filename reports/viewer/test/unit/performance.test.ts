import { describe, expect, it } from "vitest";
import type { Answer, Contact, Vec3 } from "../../src/data";
import { pathsOf } from "../../src/performance";
import type { Proof } from "../../src/proofs";

// Two cubes of side 1, of which B is moved by 0.8 along z: 0.2 deep.
const cube = (p: Vec3): Contact["A"] => ({ shape: { type: "box", half: [0.5, 0.5, 0.5] }, p, q: [1, 0, 0, 0] });
const contact: Contact = {
  A: cube([0, 0, 0]), B: cube([0, 0, 0.8]),
  truth: { touching: "touching", lo: -0.2, hi: -0.2, method: "", n: [0, 0, 1], pA: [0, 0, 0.5], pB: [0, 0, 0.3], patch: [] }, answers: [],
};
const answer = (separation: number, n: Vec3 = [0, 0, 1]): Answer => ({ status: "answered", reason: "", touching: true, separation, n });
const proof = (parts: Partial<Proof>): Proof => ({ kind: "", claim: "", said: NaN, bound: NaN, n: null, offset: NaN, claimed: null, points: [], change: "", body: "", time: NaN, angle: NaN, ...parts });
const ways = (parts: Partial<Proof> | null, of = answer(-0.2)): [number, Vec3][] => pathsOf(contact, of, parts && proof(parts), "ode").map(({ way, along }) => [way, along]);

describe("the ways that show a proof", () => {
  it("go along the normal of the answer as far as that must for an excess, and as far as it says for a depth that does not suit it", () => {
    expect(ways({ kind: "translation", claim: "normal", said: -1, bound: -0.2, claimed: [1, 0, 0] })).toEqual([[1, [1, 0, 0]]]);
    expect(ways({ kind: "overlap", said: -0.47, bound: -1, claimed: [1, 0, 0] })).toEqual([[0.47, [1, 0, 0]]]);
    expect(ways({ kind: "overlap", said: 0, bound: -1, claimed: [1, 0, 0] })).toEqual([[0, [1, 0, 0]]].map(([, along]) => [-0, along]));
  });
  it("go along the certified normal for a wrong depth alone, and along its own one where the proof names that", () => {
    expect(ways({ kind: "translation", claim: "separation", said: -0.5, bound: -0.2, n: [0, 0, 1] })).toEqual([[0.5, [0, 0, 1]]]);
    expect(ways({ kind: "no translation", claim: "separation", said: -0.1, bound: -0.2, claimed: [1, 0, 0] })).toEqual([[0.1, [1, 0, 0]]]);
    expect(ways({ kind: "translation", claim: "contact", said: -0.7, bound: -0.2, n: [0, 0, 1] })).toEqual([[0.7, [0, 0, 1]]]);
  });
  it("are those of the answer and of its variant where the two differ", () => {
    expect(ways({ kind: "variant normal", said: 1, bound: 1.4, claimed: [1, 0, 0], n: [0, 1, 0], change: "swap: A and B exchanged" })).toEqual([[1, [1, 0, 0]], [1.4, [0, 1, 0]]]);
    expect(ways({ kind: "variant separation", said: -0.3, bound: -0.1, change: "scaling: all" })).toEqual([[0.3, [0, 0, 1]], [0.1, [0, 0, 1]]]);
  });
  it("leave out the certified way itself, and proofs that are about points", () => {
    expect(ways({ kind: "variant normal", said: 0.2, bound: 1, claimed: [0, 0, 1], n: [0, 1, 0], change: "swap: A and B exchanged" })).toEqual([[1, [0, 1, 0]]]);
    expect(ways({ kind: "off surfaces", said: 1, bound: 2 }, answer(-0.2, [1, 0, 0]))).toEqual([]);
  });
  it("are those of the answer itself where the proof has no numbers", () => {
    expect(ways(null, answer(-0.2, [1, 0, 0]))).toEqual([[1, [1, 0, 0]]]);
    expect(ways(null, answer(-0.1))).toEqual([[0.1, [0, 0, 1]]]);
    expect(ways(null, answer(-0.2))).toEqual([]);
  });
});
