// A report with every kind of question, of any size, the same each time: contact questions of all shapes, falling and bouncing balls, a cloth,
// a pendulum, and hostile texts.
import { Blob } from "./encode.mjs";

export const hostile = ["<script>window.attacked = 1</script>", "</script><img src=x onerror=\"window.attacked = 1\">", "\u202Eright to left\u202C and \u0000 nothing", "<!-- <svg onload=window.attacked=1> ]]> {{7*7}} =cmd|' /C calc'!A0"];

/** Numbers in [0, 1), by xorshift. */
function makeRandom(seed) {
  let x = seed;
  return () => {
    x ^= x << 13; x ^= x >>> 17; x ^= x << 5;
    return (x >>> 0) / 4294967296;
  };
}

const oracleNames = [["cookbook", "Touchstone"], ["bullet", "Bullet"], ["bullet/gjk", "Bullet"], ["bullet_float", "Bullet"], ["ode", "ODE"], ["ode/quick", "ODE"], ["fcl/collide", "FCL"], ["libccd/epa", "libccd"], ["dart", "DART"], ["mujoco", "MuJoCo"]];
const shapes = {
  sphere: { type: "sphere", radius: 0.5 }, box: { type: "box", half: [0.5, 0.4, 0.3] }, capsule: { type: "capsule", radius: 0.3, length: 0.8 },
  cylinder: { type: "cylinder", radius: 0.4, length: 1 }, cone: { type: "cone", radius: 0.5, length: 1 }, half_space: { type: "half_space" },
  hull: { type: "hull", vertices: [[0.6, 0, 0], [-0.6, 0, 0], [0, 0.5, 0], [0, -0.5, 0], [0, 0, 0.5], [0, 0, -0.5], [0.3, 0.3, 0.25]] },
};
/** How far a shape reaches along -z, which is where A is met. */
const lowest = { sphere: 0.5, box: 0.3, capsule: 0.7, cylinder: 0.5, cone: 0.5, hull: 0.5 };
const highest = { sphere: 0.5, box: 0.3, capsule: 0.7, cylinder: 0.5, cone: 0.5, half_space: 0, hull: 0.5 };

/** A proof that states a point in both bodies, or the normal for a variant. */
const geometricProof = (q, { truth: { pA, n } }) => q % 2
  ? `bullet says apart; the point (${pA.join(", ")}) lies 0.01 m inside both.`
  : `bullet says n = (${n.join(", ")}), along which max_A n·x − min_B n·x is 0.1 m; for its variant (swap: A and B exchanged), mapped back, it says n = (0, 0.6, 0.8), along which that is 0.3 m: a difference of 0.2 m.`;

export function makeSample({ contacts = 120, worlds = 12, findings = 3000, seed = 7 } = {}) {
  const random = makeRandom(seed);
  const blob = new Blob();
  const texts = [];
  const known = new Map();
  const text = (s) => {
    if (!known.has(s)) { known.set(s, texts.length); texts.push(s); }
    return known.get(s);
  };
  const oracles = oracleNames.map(([name, library], i) => ({
    name, library, version: `${i}.1`, unit_roundoff: name === "bullet_float" ? 5.96e-8 : 1.11e-16, isolated: name === "dart", contacts: true, worlds: !name.includes("/") || name === "ode/quick",
    settings: [{ name: "margin", value: "0", why: i === 1 ? hostile[0] : "A margin rounds edges." }], parameters: i % 2 ? [{ name: "erp", set: "0", shipped: "0.2" }] : [],
  }));
  const names = {
    verdict: ["pass", "fail", "disagree", "known", "undecidable", "unsupported", "crashed", "timed out", "invalid"], undecided: ["", "truth unknown"],
    grade: ["", "rounding", "over 1e-6", "over 0.001", "over 10 %", "wrong hit or miss"], cause: ["", "convention", "tie", "precision", "discretisation", "model", "defect"],
    shipped: ["", "both as set here and as shipped", "as set here only", "as shipped only"],
    measure: [{ name: "separation_error", unit: "m", kind: "length" }, { name: "excess", unit: "m", kind: "length" }, { name: "touching", unit: "", kind: "count" }, { name: "position_error", unit: "m", kind: "length" }, { name: "energy_drift", unit: "J", kind: "other" }, { name: "answering", unit: "", kind: "count" }, { name: "stability", unit: "m", kind: "length" }],
  };

  const questions = [];
  const kinds = Object.keys(shapes);
  for (let i = 0; i < contacts; ++i) {
    const a = kinds[i % kinds.length];
    const b = kinds.filter((k) => k !== "half_space")[Math.floor(i / kinds.length) % (kinds.length - 1)];
    const depth = i % 9 === 4 ? -0.1 : i % 5 === 0 ? 1e-7 : 0.02 + 0.1 * random();
    const sphereAt = [0.05, 0.02, highest[a] + lowest[b] - depth];
    const pA = [0.05, 0.02, highest[a]];
    const pB = [0.05, 0.02, highest[a] - depth];
    const mid = [0.05, 0.02, highest[a] - depth / 2];
    const wrong = (o) => o % 3 === 1;
    questions.push({
      id: `contact/${a}_${b}/case_${String(i).padStart(4, "0")}`, group: `contact/${a}_${b}`, kind: "contact", pair: `${a}–${b}`, size: 0.8,
      title: i < hostile.length ? hostile[i] : depth < 0 ? `A ${b} above a ${a}` : `A ${b} sinks ${depth < 1e-3 ? "hardly" : "a little"} into a ${a}`,
      toml: `id = "case_${i}"\ntitle = '''${hostile[i % hostile.length]}'''\n`,
      contact: {
        A: { shape: shapes[a], p: [0, 0, 0], q: [1, 0, 0, 0] }, B: { shape: shapes[b], p: sphereAt, q: [1, 0, 0, 0] },
        truth: { touching: depth < 0 ? "apart" : "touching", lo: -depth - 1e-15, hi: -depth, method: "polytope", n: [0, 0, 1], pA, pB, patch: b === "box" && depth > 0 ? [[0.2, 0.2, mid[2]], [-0.2, 0.2, mid[2]], [-0.2, -0.2, mid[2]], [0.2, -0.2, mid[2]]] : [] },
        answers: oracles.map((_, o) => o === 8 ? { status: "unsupported", reason: hostile[2] } : o === 9 && i === 3 ? { status: "crashed", reason: "SIGSEGV" } : {
          status: "answered", reason: "", touching: depth >= 0, n: wrong(o) ? [0.6, 0, 0.8] : [0, 0, 1], separation: wrong(o) ? -depth * 1.05 : -depth,
          points: depth < 0 ? [] : [{ p: mid, s: -depth }, { p: [mid[0] + 0.1, mid[1], mid[2]], s: -depth }], witnesses: o % 2 ? [pA, pB] : undefined,
        }),
      },
    });
  }
  for (let w = 0; w < worlds; ++w) questions.push(makeWorld(w, blob, oracles, random));
  const order = (q) => (q.kind === "contact" ? 0 : 1);
  questions.sort((x, y) => order(x) - order(y) || (x.id < y.id ? -1 : 1));

  const reasons = Array.from({ length: 30 }, (_, i) => i === 0 ? hostile[1] : `The ${["face", "edge", "vertex"][i % 3]} test of case ${i} prefers an axis unless another is ${i + 1} % shallower, by EPA of btGjkEpa2.`);
  const ledger = reasons.map((reason, i) => ({ scenarios: [`contact/box_box/*`, hostile[i % 4]], oracle: oracleNames[1 + (i % 9)][0], version: "1", verdict: "fail", measures: ["separation_error"], cause: "defect", fault: i < 2 ? "Two entries have one fault." : undefined, reason, upstream: i % 3 ? "unreported" : i === 0 ? "javascript:window.attacked=1" : "https://example.org/issues/1", expires: "2027-11-21", uses: 10 * i }));
  const columns = ["question", "oracle", "measure", "law", "reference", "verdict", "undecided", "grade", "cause", "shipped", "value", "tolerance", "share", "because", "cause_because", "shipped_because", "proof", "ledger", "cluster", "time"];
  const f = Object.fromEntries(columns.map((c) => [c, []]));
  const per = Math.max(1, Math.round(findings / (questions.length * oracles.length)));
  const perCluster = Array.from({ length: 30 }, () => ({ oracles: new Set(), questions: new Set(), worst: -1, share: -1, findings: 0 }));
  let n = 0;
  questions.forEach((question, q) => oracles.forEach((_, o) => {
    for (let k = 0; k < per; ++k, ++n) {
      const world = question.kind === "world";
      const crashed = question.contact?.answers[o].status === "crashed" && k === 0;
      const verdict = crashed ? 6 : o === 8 && !world ? 5 : world && !question.world.motions[o].bodies.length ? 5 : o % 3 === 1 && k === 0 ? (n % 7 ? 3 : 1) : random() < 0.04 ? 4 : 0;
      const fault = verdict === 3 || verdict === 1;
      const share = fault ? 10 ** (-9 + 9 * random()) : verdict === 0 ? (random() < 0.2 ? 0 : 10 ** (-17 + 3 * random())) : 0;
      const cluster = fault ? (q + o) % 30 : -1;
      if (cluster >= 0) {
        const c = perCluster[cluster];
        c.oracles.add(o); c.questions.add(q); ++c.findings;
        if (share > c.share) { c.share = share; c.worst = n; }
      }
      const put = { question: q, oracle: o, measure: verdict === 5 || crashed ? 5 : world ? (k % 2 ? (q % 3 ? 4 : 6) : 3) : k % 3, law: world ? text(k % 2 ? "conserves_energy" : "bounce_series") : -1, reference: text("referee"), verdict, undecided: verdict === 4 ? 1 : 0,
        grade: fault && !world ? 1 + (share > 1e-6) + (share > 1e-3) + (share > 0.1) : 0, cause: fault ? 3 + (n % 4) : 0, shipped: fault && world ? 1 : 0,
        value: crashed ? 1 : n === 17 ? "inf" : share * question.size, tolerance: 1e-12, share, because: text("64 roundings of 2^-53"), cause_because: fault ? text(world ? "0.6, 0.3 and 0.15 at the step, a half and a quarter of it: it vanishes with the step" : "no known convention accounts for it") : -1, shipped_because: fault && world ? text("1.1 m where 0.3 m is allowed as shipped") : -1,
        proof: fault ? text(o === 1 && k === 0 && question.contact ? geometricProof(q, question.contact) : n % 50 === 0 ? hostile[n % 4] : `${oracles[o].name} says ${n % 1000} mm, a separated pair ${n % 13}`) : -1, ledger: verdict === 3 ? cluster : -1, cluster, time: fault && world ? question.world.times[Math.floor(question.world.times.length * (0.2 + 0.5 * random()))] : -1 };
      for (const c of columns) f[c].push(put[c]);
    }
  }));
  const kept = perCluster.map((c, i) => ({ c, i })).filter(({ c }) => c.findings > 0).sort((a, b) => b.c.share - a.c.share);
  const place = new Map(kept.map(({ i }, p) => [i, p]));
  f.cluster = f.cluster.map((c) => (c < 0 ? -1 : place.get(c)));
  const clusters = kept.map(({ c, i }) => ({
    title: i === 5 ? hostile[0] : `Case ${i} prefers an axis unless another is ${i + 1} % shallower.`,
    extent: `${[...c.oracles].map((o) => oracles[o].name).join(", ")}, in ${c.questions.size} scenarios, at worst ${(c.share * 80).toPrecision(2)} cm, ${(c.share * 100).toPrecision(2)} % of the size.`,
    reason: reasons[i], upstream: ledger[i].upstream, is_new: i % 4 === 3, grade: c.share > 0.1 ? 4 : c.share > 1e-3 ? 3 : c.share > 1e-6 ? 2 : 1, cause: 6, oracles: [...c.oracles], questions: [...c.questions].sort((a, b) => (a === f.question[c.worst] ? -1 : b === f.question[c.worst] ? 1 : a - b)),
    worst: c.worst, error: f.value[c.worst] === "inf" ? 1 : f.value[c.worst], unit: "m", share: c.share, ordinary: 0.5,
  }));
  const report = {
    format: "touchstone report data", version: 1, program: "touchstone 0.1.0", command: "touchstone run", sentence: `${oracles.length} oracles answered ${contacts} contact questions and ${worlds} worlds.`, conclusion: "OK: every fault is known.", failed: false, subject: 0,
    oracles, questions, texts, names, findings: f, clusters, ledger, faults: [hostile[0]], regressions: [],
    compare: { old: "yesterday", new: "today", rows: ["worse", "no longer judged", "new", "better", "gone"].flatMap((kind, k) => [0, 1].map((j) => ({ kind, question: questions[k + j].id, oracle: "bullet", measure: "separation_error", law: "", before: kind === "new" ? null : 1e-5, after: kind === "gone" ? null : 2e-3, unit: "m", what: hostile[j] }))) },
  };
  return { report, blob };
}

/** A ball that falls and bounces beside a box that slides, as each engine has it; some worlds have a cloth or a pendulum. */
function makeWorld(w, blob, oracles, random) {
  const dt = 0.01;
  const steps = 200;
  const times = Array.from({ length: 101 }, (_, i) => i * 2 * dt);
  const fall = (t, e) => {
    let h = 2;
    let v = 0;
    for (let s = 0; s < t - 1e-9; s += dt) { v -= 9.81 * dt; h += v * dt; if (h < 0.3) { h = 0.3; v = -e * v; } }
    return { h, v };
  };
  const cloth = w % 4 === 1;
  const pendulum = w % 4 === 2;
  const truth = times.map((t) => fall(t, 0.8).h);
  const motions = oracles.map((oracle, o) => {
    if (!oracle.worlds) return { status: "unsupported", reason: "contacts only", bodies: [] };
    const e = 0.8 - 0.04 * o + 0.01 * random();
    const ball = times.map((t) => fall(t, e));
    const channels = (x, y, z, vz, spin) => [x, y, z, times.map((t) => Math.cos(spin * t / 2)), times.map(() => 0), times.map(() => 0), times.map((t) => Math.sin(spin * t / 2)), times.map(() => 0), times.map(() => 0), vz, times.map(() => 0), times.map(() => 0), times.map(() => spin)];
    const scales = [1e-6, 1e-6, 1e-6, 1e-6, 1e-6, 1e-6, 1e-6, 1e-5, 1e-5, 1e-5, 1e-5, 1e-5, 1e-5];
    const track = (...c) => blob.track(channels(...c), scales);
    const hits = times.map((_, i) => i).filter((i) => i > 0 && ball[i].v > 0 && ball[i - 1].v < 0);
    return {
      status: "answered", reason: "",
      bodies: [null, track(times.map(() => 0), times.map(() => 0), ball.map((b) => b.h), ball.map((b) => b.v), 0), track(times.map((t) => 1 + 0.4 * t - 0.02 * o * t * t), times.map(() => 0), times.map(() => 0.2), times.map(() => 0), 0.3 * o)],
      points: cloth ? blob.track(Array.from({ length: 3 * 17 }, (_, k) => times.map((t) => k < 3 ? [-1, 0, 1 + 0.2 * Math.sin(3 * t)][k] : [-1 + 0.2 * (Math.floor((k - 3) / 3) % 4), 1 + 0.2 * Math.floor((k - 3) / 12), 1 + 0.1 * Math.sin(2 * t + Math.floor((k - 3) / 12))][k % 3])), new Array(51).fill(1e-5)) : undefined,
      impulses: hits.length ? blob.track([hits, hits.map(() => 0), hits.map(() => 1), hits.map(() => 0), hits.map(() => 0), hits.map(() => 0), hits.map(() => 0), hits.map(() => 0), hits.map(() => 1), hits.map(() => 0), hits.map(() => 0), hits.map((i) => Math.abs(ball[i].v) * 2), hits.map(() => -1e-4)], [1, 1, 1, ...new Array(10).fill(1e-6)]) : undefined,
    };
  });
  // One world has a crowd of balls.
  const crowd = w === 3 ? 25 : 0;
  for (const { bodies } of motions) if (bodies.length) bodies.push(...Array.from({ length: crowd }, () => bodies[1]));
  const heights = oracles.map((o, i) => o.worlds ? blob.track([times.map((t) => fall(t, 0.8 - 0.04 * i).h)], [1e-6]) : null);
  return {
    id: `world/bounce/ball_${String(w).padStart(3, "0")}`, group: "world/bounce", title: w === 1 ? hostile[1] : "A ball bounces beside a box that slides", kind: "world", size: 0.6, toml: `id = "world ${w}"\n`,
    world: {
      dt, steps, gravity: [0, 0, -9.81],
      bodies: [{ name: "floor", shape: { type: "half_space" }, fixed: true, start: { p: [0, 0, 0], q: [1, 0, 0, 0] } }, { name: w === 1 ? hostile[0] : "ball", shape: { type: "sphere", radius: 0.3 }, fixed: false, start: { p: [0, 0, 2], q: [1, 0, 0, 0] } }, { name: "box", shape: { type: "box", half: [0.3, 0.2, 0.2] }, fixed: false, start: { p: [1, 0, 0.2], q: [1, 0, 0, 0] } },
        ...Array.from({ length: crowd }, (_, i) => ({ name: `ball ${i}`, shape: { type: "sphere", radius: 0.3 }, fixed: false, start: { p: [0, 0, 2], q: [1, 0, 0, 0] } }))],
      particles: cloth ? [{ name: "mote", radius: 0.05 }] : [], springs: pendulum ? [{ A: 1, B: -1, pA: [0, 0, 0.3], pB: [0, 0, 3] }] : [], joints: pendulum ? [{ A: 1, B: 2, pA: [0, 0, 0], pB: [0, 0, 0], kind: "distance" }] : [], cloths: cloth ? [{ rows: 4, columns: 4 }] : [],
      claims: ["the ball rises to e² of its height", "energy never rises"], times, thinned: 2, motions,
      curves: [{ quantity: "height", unit: "m", body: 1, truth: blob.track([truth], [1e-6]), tolerance: 0.05, finding: 0, breaks: oracles.map((o, i) => o.worlds && i ? 0.7 + 0.05 * i : null), motions: heights },
        { quantity: "energy", unit: "J", tolerance: 20, motions: heights }],
    },
  };
}
