import { describe, expect, it } from "vitest";
import { proofClause } from "../../src/proof_clause";
import { proofParts } from "../../src/proof_text";
import { apart } from "../../src/format";
import { startingRate } from "../../src/playback_rate";
import { separateLabels } from "../../src/scene/label_places";
import { turnOf, type Proof } from "../../src/proofs";
import { profileView } from "../../src/scene/view_direction";
import { dot, norm } from "../../src/vector";
import { leftOut } from "../../src/histogram";
import { splitAtError } from "../../src/error_in_proof";
import { placeCameraAround, cameraFor } from "../../src/scene/stage";
import * as three from "three";

describe("a proof in a clause", () => {
  it("has three digits of each number, and no name of a law", () => {
    expect(proofClause("never_passes_through, true of every motion: ode has ball apart from wall at 0.123456 s")).toBe("ode has ball apart from wall at 0.123 s");
    expect(proofClause("bullet says 0.0135123456 m deep; moving B by 1.2345678e-07 m along (0.6, 0, -0.812345) separates them.")).toBe("bullet says 0.0135 m deep; moving B by 1.23e-7 m separates them.");
    expect(proofClause("fcl says n = (0, 0, 1), along which B must move 0.6 m; moving B by 0.22 m along (1, 0, 0) separates them, 0.38 m less.")).toBe("fcl makes B move 0.6 m, where 0.22 m are enough, 0.38 m less.");
    expect(proofClause("fcl says n = (0, 0, 1), along which B must move 0.01000004 m; moving B by 0.01 m along (1, 0, 0) separates them.")).toBe("fcl makes B move 0.01000004 m, where 0.01 m are enough.");
    expect(proofClause("ode has b at (0.123456, 0, 1) after 1 s; it is at (2, 0, 0)")).toBe("ode has b at (0.123, 0, 1) after 1 s; it is at (2, 0, 0)");
    expect(proofClause("libccd/epa puts its points at (0.1, 0.2, 0.3) on A and (0, 0, 1e-3) on B; these are 1.5 m and 0.0123456 m from the surfaces.")).toBe("libccd/epa puts its points 1.5 m and 0.0123 m from the surfaces.");
    expect(proofClause("ode says apart; the point (0.5, 1, 2) lies 0.01 m inside both.")).toBe("ode says apart; a point lies 0.01 m inside both.");
    expect(proofClause("fcl says n = (1, 0, 0), along which that is 1 m; for its variant (rigid_motion: both turned by (0.3, 0.5) about the origin, then moved by (0.7, -0.4, 1)), mapped back, it says n = (0, 1, 0), along which that is 2 m")).toBe("fcl says a normal along which that is 1 m; for the same question moved as a whole it says one along which that is 2 m");
    // The difference is the rounding of the length beside it: more digits would not add up.
    expect(proofClause("bullet says 0 m along (0, 0, 1); the overlap along it is 659.493 m, 659 m more.")).toBe("bullet says 0 m along its normal; the overlap along that is 659 m, 659 m more.");
    expect(proofClause("libccd/mpr answers the question, but not its variant (scaling: all lengths times 0.136986301): n_AB_W has length 0, not 1 to within 2.1e-15.")).toBe("libccd/mpr answers the question, but not the same one scaled, although that changes nothing else: its normal has length 0, not 1 to within 2.1e-15.");
    expect(proofClause("ode has “crate 20261126” off reference-20261126.csv:2 by 0.123456 m")).toBe("ode has “crate 20261126” off reference-20261126.csv:2 by 0.123 m");
    expect(proofClause("fcl/distance: aborted: ./include/fcl/narrowphase/gjk_libccd-inl.h:1327: Assertion `isOutside(&f)' failed.")).toBe("fcl/distance: aborted: gjk_libccd-inl.h:1327: Assertion `isOutside(&f)' failed.");
    expect(proofClause("dart: diverged in step 4692, at 4.692 s")).toBe("diverged in step 4692, at 4.69 s");
    expect(proofClause("expect[3]: bullet3_24 gives 1234567 m")).toBe("bullet3_24 gives 1.23e6 m");
  });
});

describe("a proof in full", () => {
  const shown = (text: string) => proofParts(text).map((part) => part.shown).join("");
  it("has six digits of each number, or as many as tell two apart", () => {
    expect(shown("ode says 0.12345678901 m at (0.10000000001, -2.5, 3e-17)")).toBe("ode says 0.123457 m at (0.1, -2.5, 3e-17)");
    expect(shown("“lid” is at (0.1, 1.00000012, 0) and (0.1, 1.00000031, 0)")).toBe("“lid” is at (0.1, 1.0000001, 0) and (0.1, 1.0000003, 0)");
    expect(shown("“crate 20261126” is off reference-20261126.csv:2")).toBe("“crate 20261126” is off reference-20261126.csv:2");
    expect(proofParts("0.12345678901 m")[1]).toEqual({ shown: "0.123457", whole: "0.12345678901" });
  });
});

describe("numbers side by side", () => {
  it("have the fewest digits that tell them apart, unless they differ by a rounding only", () => {
    expect(apart([0.2, 0.2000000013, 0.3])).toEqual(["0.2", "0.200000001", "0.3"]);
    expect(apart([17.33441, 17.33462, 17.33462], 4)).toEqual(["17.334", "17.335", "17.335"]);
    expect(apart([1, 1 + 2 ** -52], 4)).toEqual(["1", "1"]);
    expect(apart([])).toEqual([]);
  });
});

describe("the rate of a first playback", () => {
  it("makes a short motion last about four seconds, and a longer one as long as in life", () => {
    expect([0.05, 0.4, 1, 1.9, 2.7, 3, 4, 60].map(startingRate)).toEqual([0.01, 0.1, 0.2, 0.5, 0.5, 1, 1, 1]);
  });
});

describe("labels", () => {
  it("make way for earlier ones, and for those alone", () => {
    const box = (x: number, y: number) => ({ x, y, width: 20, height: 10 });
    expect(separateLabels([box(0, 0), box(5, 0), box(100, 0)])).toEqual([[0, 0], [0, 10], [0, 0]]);
    expect(separateLabels([box(0, 0), box(0, 10), box(0, 0)])).toEqual([[0, 0], [0, 0], [0, -10]]);
  });
  it("go beside a narrow one rather than far from what they name", () => {
    const letters = [{ x: 0, y: 0, width: 8, height: 10 }, { x: 0, y: 10, width: 8, height: 10 }];
    expect(separateLabels([...letters, { x: 0, y: 4, width: 90, height: 10 }])).toEqual([[0, 0], [0, 0], [8, 0]]);
  });
});

describe("an error that is mostly an angle", () => {
  const places = (x: number): Proof => ({ kind: "places", claim: "", said: NaN, bound: NaN, n: null, offset: NaN, claimed: null, points: [[0, 0, 0], [x, 0, 0]], change: "", body: "box", time: 1, angle: 3.07 });
  it("leads with the angle", () => {
    expect(turnOf(places(0.03), 2.5)).toBe("176° and 3 cm");
    expect(turnOf(places(2), 2.5)).toBeNull();
    expect(turnOf(null, 2.5)).toBeNull();
    expect(turnOf({ ...places(0.03), angle: NaN }, 2.5)).toBeNull();
  });
});

describe("the first view of a contact", () => {
  it("has the normal and the claimed one in the plane of the screen", () => {
    for (const [n, claimed] of [[[0, 0, 1], [0.6, 0, 0.8]], [[1, 0, 0], [0, 1, 0]], [[0.36, 0.48, 0.8], null], [[0, 0, 1], [1e-5, 0, 1]], [[0.55, 0.75, 0.45], null]] as [[number, number, number], [number, number, number] | null][]) {
      const view = profileView(n, claimed);
      expect(norm(view)).toBeCloseTo(1, 12);
      expect(Math.abs(dot(view, n))).toBeLessThan(1e-4);
      if (claimed) expect(Math.abs(dot(view, claimed))).toBeLessThan(1e-4);
    }
  });
});

describe("a distribution", () => {
  it("says what it leaves out", () => {
    expect(leftOut(7, [1e-20, 1e-3, 0.5, 300, 0], [-17, 2])).toBe("4 findings of 7 by error as a share of the size, logarithmic; 2 beyond the axis count at its ends; 1 without a size is not shown; 2 that are no lengths (hits and misses, counts, angles, energies) are not shown");
    expect(leftOut(2, [0.1, 0.2], [-17, 2])).toBe("2 findings of 2 by error as a share of the size, logarithmic");
  });
});

describe("the error in a proof", () => {
  it("is its last number of that size and unit", () => {
    expect(splitAtError("dart says 0.47 m; the overlap is 1.02 m, 0.549 m more.", { value: 0.5487, unit: "m" })).toEqual(["dart says 0.47 m; the overlap is 1.02 m, ", "0.549 m", " more."]);
    expect(splitAtError("it moves at 0.549 m/s", { value: 0.549, unit: "m" })).toBeNull();
    expect(splitAtError("it gains 0.2201 J of 0.22 J", { value: 0.22, unit: "J" })?.[0]).toBe("it gains 0.2201 J of ");
    expect(splitAtError("“box_0.549 m” is at (0.1, 0.549, 3)", { value: 0.549, unit: "m" })).toBeNull();
    expect(splitAtError("they are 4.7e-10 m apart", { value: 4.69e-10, unit: "m" })?.[1]).toBe("4.7e-10 m");
  });
});

describe("a camera around balls", () => {
  it("sees all of them, and comes as near as it can", () => {
    const balls = [{ at: new three.Vector3(-5, 0, 0), radius: 0.3 }, { at: new three.Vector3(4, 1, 2), radius: 1 }, { at: new three.Vector3(0, 0, -1), radius: 0.1 }];
    for (const aspect of [0.6, 1, 2]) for (const direction of [[1, 2, 0.5], [0, 0, 1], [1, 0, 0]] as const) {
      const camera = cameraFor(aspect);
      camera.up.set(0, 0, 1);
      placeCameraAround(camera, balls, new three.Vector3(...direction));
      camera.updateMatrixWorld(true);
      let most = 0;
      for (const { at, radius } of balls) for (const axis of [0, 1, 2]) for (const sign of [-1, 1]) {
        const p = at.clone().setComponent(axis, at.getComponent(axis) + sign * radius).project(camera);
        expect(p.z).toBeLessThan(1);
        most = Math.max(most, Math.abs(p.x), Math.abs(p.y));
      }
      expect(most).toBeLessThan(0.95);
      expect(most).toBeGreaterThan(0.7);
    }
  });
});
