import { describe, expect, it } from "vitest";
import { commonPoint, contactVariant, stepStudy, worldVariant } from "../../src/proof_text";

describe("a proof", () => {
  it("states the normal of a variant, with all its digits", () => {
    expect(contactVariant("ode says n = (1, 0, 0), along which max_A n·x − min_B n·x is 0.6 m; for its variant (rigid_motion: both turned by the quaternion (0.3107, 0.531197, -0.591332, 0.521174) about the origin, then moved by (0.71, -0.43, 0.97)), mapped back, it says n = (-0.6334106990543655, 2.5e-17, 0.7192084832440319), along which that is 1.5 m: a difference of 0.887 m."))
      .toEqual({ name: "rigid_motion", how: "both turned by the quaternion (0.3107, 0.531197, -0.591332, 0.521174) about the origin, then moved by (0.71, -0.43, 0.97)", n: [-0.6334106990543655, 2.5e-17, 0.7192084832440319] });
  });

  it("states where a body is in a world and in its variant", () => {
    expect(worldVariant("bullet is up to 0.1 m away if its start is moved by 2.27e-13 m: at 1.2 s to_45 is at (1.8, 8.8, 0.2) and (1.7, 8.7, -3e-5), 0.02 rad apart"))
      .toEqual({ time: 1.2, body: "to_45", own: [1.8, 8.8, 0.2], variant: [1.7, 8.7, -3e-5] });
  });

  it("states the point that is in both bodies", () => {
    expect(commonPoint("bullet says apart; the point (-0.0008, 1e-3, 2) lies 2.99e-06 m inside both.")).toEqual([-0.0008, 1e-3, 2]);
  });

  it("states the errors at three steps", () => {
    expect(stepStudy("0.597, 0.343 and 2.1e-5 at the step, a half and a quarter of it: it vanishes with the step")).toEqual({ errors: [0.597, 0.343, 2.1e-5], conclusion: "it vanishes with the step" });
    expect(stepStudy("3, 2 and 1 N at the step, a half and a quarter of it: to vanish")?.errors).toEqual([3, 2, 1]);
    expect(stepStudy("it does not approach the truth as the step shrinks")).toBeNull();
  });

  it.each(["", "ode returns 6 contacts", "the point (1, 2) lies 3 m inside both", "for its variant (swap: A and B exchanged), mapped back, it says n = (NaN, 0, 0)"])("may state none of them: %s", (proof) => {
    expect([contactVariant(proof), worldVariant(proof), commonPoint(proof)]).toEqual([null, null, null]);
  });
});
