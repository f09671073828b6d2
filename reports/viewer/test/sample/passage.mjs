// A world in which a ball flies through a thin wall for one oracle, and rebounds for the first.

/** Gives a world of the sample a ball at 40 m/s and a wall 1 cm thick, which the oracle of the finding does not see.
 * @returns the address of the finding */
export function passThroughWall({ report, blob }, finding) {
  const { findings: f, questions, oracles, names, cited } = report;
  const question = questions[f.question[finding]];
  const times = Array.from({ length: 21 }, (_, k) => 0.02 * k);
  const zero = times.map(() => 0);
  const one = times.map(() => 1);
  const scales = new Array(13).fill(1e-6);
  const track = (x, v) => blob.track([x, zero, zero, one, zero, zero, zero, v, zero, zero, zero, zero, zero], scales);
  // The gap to the wall is 0.795 m at the start: it is met 0.02 s later.
  const flies = track(times.map((t) => -0.5 + 40 * t), times.map(() => 40));
  const rebounds = track(times.map((t) => (t <= 0.02 ? -0.5 + 40 * t : 0.3 + 0.59 - 40 * (t - 0.02))), times.map((t) => (t <= 0.02 ? 40 : -40)));
  const motion = (o) => (oracles[o].worlds ? { status: "answered", reason: "", bodies: [null, o === f.oracle[finding] ? flies : rebounds] } : { status: "unsupported", reason: "contacts only", bodies: [] });
  const start = (x) => ({ p: [x, 0, 0], q: [1, 0, 0, 0] });
  question.world = {
    ...question.world, dt: 0.02, steps: 20, gravity: [0, 0, 0], thinned: 1, times, particles: [], springs: [], joints: [], cloths: [], curves: [],
    bodies: [{ name: "wall", shape: { type: "box", half: [0.005, 1, 1] }, fixed: true, start: start(1) }, { name: "thrown", shape: { type: "sphere", radius: 0.1 }, fixed: false, start: start(-0.5) }],
    motions: oracles.map((_, o) => motion(o)),
  };
  names.measure.push({ name: "passage", unit: "m", kind: "length" });
  f.measure[finding] = names.measure.length - 1;
  f.time[finding] = 0.06;
  // No other finding of the world names bodies or moments that are gone.
  f.question.forEach((q, i) => { if (q === f.question[finding] && i !== finding) f.time[i] = -1; });
  const kept = cited.finding.map((i) => f.question[i] !== f.question[finding]);
  for (const column of Object.keys(cited)) cited[column] = cited[column].filter((_, row) => kept[row]);
  cited.finding.push(finding); cited.bodies.push([1, 0]); cited.points.push([]);
  return `#/s/${encodeURIComponent(question.id)}?o=${encodeURIComponent(oracles[f.oracle[finding]].name)}&f=${finding}`;
}
