/** An oracle for two spheres: how deep they overlap, or how far they are apart. */

import { serve } from "./touchstone_oracle.mjs";

const about = {
  name: "balls",
  library: "balls.mjs",
  version: "1.0",
  subtracts_first: true,
  contact: [
    {
      pairs: [["sphere", "sphere"]],
      family: "closed_form",
      gives: ["depth", "distance", "normal", "manifold"],
    },
  ],
};

function contact(A, B) {
  const d = B.position.map((x, i) => x - A.position[i]);
  // Unlike the root of the sum of squares, hypot() never overflows or underflows.
  const distance = Math.hypot(...d);
  const separation = distance - (A.radius + B.radius);
  // Every direction is equally right for two balls with one centre.
  const normal = distance > 0 ? d.map((x) => x / distance) : [0, 0, 1];
  if (separation > 0) return { touching: false, separation, normal };
  // Midway between the two surfaces.
  const position = A.position.map((x, i) => x + (A.radius + separation / 2) * normal[i]);
  return { touching: true, separation, normal, points: [{ position, separation }] };
}

serve({ about, contact });
