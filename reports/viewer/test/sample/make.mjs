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

const tenOracles = [["cookbook", "Touchstone"], ["bullet", "Bullet"], ["bullet/gjk", "Bullet"], ["bullet_float", "Bullet"], ["ode", "ODE"], ["ode/quick", "ODE"], ["fcl/collide", "FCL"], ["libccd/epa", "libccd"], ["dart", "DART"], ["mujoco", "MuJoCo"]];
/** All oracles of a full run. */
export const allOracles = [...tenOracles.slice(0, 1), ["cookbook/batch", "Touchstone"], ...tenOracles.slice(1, 4), ["bullet_float/gjk", "Bullet"], ...tenOracles.slice(4, 7), ...["fcl/distance", "fcl/signed_distance", "fcl/collide_indep", "fcl/distance_indep", "fcl/signed_distance_indep"].map((name) => [name, "FCL"]), ["libccd/epa", "libccd"], ["libccd/mpr", "libccd"], ["dart", "DART"], ["mujoco", "MuJoCo"], ["mujoco/rk4", "MuJoCo"]];
const shapes = {
  sphere: { type: "sphere", radius: 0.5 }, box: { type: "box", half: [0.5, 0.4, 0.3] }, capsule: { type: "capsule", radius: 0.3, length: 0.8 },
  cylinder: { type: "cylinder", radius: 0.4, length: 1 }, cone: { type: "cone", radius: 0.5, length: 1 }, half_space: { type: "half_space" },
  hull: { type: "hull", vertices: [[0.6, 0, 0], [-0.6, 0, 0], [0, 0.5, 0], [0, -0.5, 0], [0, 0, 0.5], [0, 0, -0.5], [0.3, 0.3, 0.25]] },
};
/** How far a shape reaches along -z, which is where A is met. */
const lowest = { sphere: 0.5, box: 0.3, capsule: 0.7, cylinder: 0.5, cone: 0.5, hull: 0.5 };
const highest = { sphere: 0.5, box: 0.3, capsule: 0.7, cylinder: 0.5, cone: 0.5, half_space: 0, hull: 0.5 };

const proofKinds = ["", "plane", "common point", "variant normal", "variant separation", "places"];

/** A proof with a point in both bodies, the normal for a variant, or the separation of one. */
const geometricProof = (q, { truth: { pA, n, hi } }) => q % 3 === 1 ? { kind: 2, claim: 2, bound: -0.01, points: [pA], words: `bullet says apart; the point (${pA.join(", ")}) lies 0.01 m inside both.` }
  : q % 3 === 0 ? { kind: 3, said: 0.1, bound: 0.3, n: [0, 0.6, 0.8], claimed: n, change: "swap: A and B exchanged", words: `bullet says n = (${n.join(", ")}); for its variant (swap: A and B exchanged) it says another.` }
    : { kind: 4, said: hi, bound: hi / 2, change: "scaling: all lengths times 2", words: "bullet says one depth; for its variant (scaling: all lengths times 2) it says half of it." };

export function makeSample({ contacts = 120, worlds = 12, findings = 3000, seed = 7, names: oracleNames = tenOracles } = {}) {
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
    grade: ["", "rounding", "over 1e-6", "over 0.001", "over 10 %", "wrong hit or miss", "unusable"], cause: ["", "convention", "tie", "precision", "discretisation", "model", "setting", "defect"],
    shipped: ["", "both as set here and as shipped", "as set here only", "as shipped only"], proof: proofKinds, claim: ["", "touching", "apart"],
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
  const proofs = Object.fromEntries(["finding", "kind", "claim", "said", "bound", "n", "offset", "claimed", "points", "change", "body", "time"].map((c) => [c, []]));
  const studies = { finding: [], errors: [], unit: [] };
  const cited = { finding: [], bodies: [], points: [] };
  const addProof = (finding, { kind, claim = 0, said = null, bound = null, n = null, claimed = null, points = [], change, body, time = null }) => {
    const put = { finding, kind, claim, said, bound, n, offset: null, claimed, points, change: change ? text(change) : -1, body: body ? text(body) : -1, time };
    for (const [column, value] of Object.entries(put)) proofs[column].push(value);
  };
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
      const geometric = fault && o === 1 && k === 0 && question.contact ? geometricProof(q, question.contact) : null;
      if (geometric) addProof(n, geometric);
      else if (fault && world && k % 2 && q % 3 === 0) addProof(n, { kind: 5, points: [[0, 0, 1], [0.1, 0, 1]], body: "ball", time: question.world.times[20] });
      if (fault && world && k % 2) { cited.finding.push(n); cited.bodies.push([1]); cited.points.push([]); }
      if (fault && world) { studies.finding.push(n); studies.errors.push([0.6, 0.3, 0.15]); studies.unit.push("m"); }
      const put = { question: q, oracle: o, measure: verdict === 5 || crashed ? 5 : world ? (k % 2 ? (q % 3 ? 4 : 6) : 3) : k % 3, law: world ? text(k % 2 ? "conserves_energy" : "bounce_series") : -1, reference: text("referee"), verdict, undecided: verdict === 4 ? 1 : 0,
        grade: crashed ? 6 : fault ? 1 + (share > 1e-6) + (share > 1e-3) + (share > 0.1) : 0, cause: fault ? [3, 4, 5, 7][n % 4] : 0, shipped: fault && world ? 1 : 0,
        value: crashed ? 1 : n === 17 ? "inf" : share * question.size, tolerance: 1e-12, share, because: text("64 roundings of 2^-53"), cause_because: fault ? text(world ? "0.6, 0.3 and 0.15 at the step, a half and a quarter of it: it vanishes with the step" : "no known convention accounts for it") : -1, shipped_because: fault && world ? text("1.1 m where 0.3 m is allowed as shipped") : -1,
        proof: fault ? text(geometric ? geometric.words : n % 50 === 0 ? hostile[n % 4] : `${oracles[o].name} says ${n % 1000} mm, a separated pair ${n % 13}`) : -1, ledger: verdict === 3 ? cluster : -1, cluster, time: fault && world ? question.world.times[Math.floor(question.world.times.length * (0.2 + 0.5 * random()))] : -1 };
      for (const c of columns) f[c].push(put[c]);
    }
  }));
  const kept = perCluster.map((c, i) => ({ c, i })).filter(({ c }) => c.findings > 0).sort((a, b) => b.c.share - a.c.share);
  const place = new Map(kept.map(({ i }, p) => [i, p]));
  f.cluster = f.cluster.map((c) => (c < 0 ? -1 : place.get(c)));
  const clusters = kept.map(({ c, i }) => ({
    title: i === 5 ? hostile[0] : `Case ${i} prefers an axis unless another is ${i + 1} % shallower.`,
    extent: `${[...c.oracles].map((o) => oracles[o].name).join(", ")}, in ${c.questions.size} scenarios, at worst ${(c.share * 80).toPrecision(2)} cm, ${(c.share * 100).toPrecision(2)} % of the smaller body.`,
    reason: reasons[i], upstream: ledger[i].upstream, is_new: i % 4 === 3, grade: c.share > 0.1 ? 4 : c.share > 1e-3 ? 3 : c.share > 1e-6 ? 2 : 1, cause: 7, oracles: [...c.oracles], questions: [...c.questions].sort((a, b) => (a === f.question[c.worst] ? -1 : b === f.question[c.worst] ? 1 : a - b)),
    worst: c.worst, error: f.value[c.worst] === "inf" ? 1 : f.value[c.worst], unit: "m", share: c.share, ordinary: 0.5,
  }));
  const report = {
    format: "touchstone report data", version: 1, program: "touchstone 0.1.0", command: "touchstone run", sentence: `${oracles.length} oracles answered ${contacts} contact questions and ${worlds} worlds.`, conclusion: "OK: every fault is known.", failed: false, subject: 0,
    oracles, questions, texts, names, findings: f, proofs, cited, studies, clusters, ledger, faults: [hostile[0]], regressions: [],
    seconds: questions.map((q, i) => oracles.map((o, k) => ((q.contact ? o.contacts : o.worlds) ? (q.contact ? 1e-6 : 0.1) * (1 + ((7 * i + 3 * k) % 11)) : null))),
    spent: { motions: { itself: 2, "half step": 4.5, mirror: 1 }, laws: { never_penetrates: 0.5 }, contacts: { truth: 0.25, swap: 0.125 } },
    compare: { old: "yesterday", new: "today", rows: ["worse", "no longer judged", "new", "better", "gone"].flatMap((kind, k) => [0, 1].map((j) => ({ kind, question: questions[k + j].id, oracle: "bullet", measure: "separation_error", law: "", before: kind === "new" ? null : 1e-5, after: kind === "gone" ? null : 2e-3, unit: "m", what: hostile[j] }))) },
  };
  return { report, blob };
}

const add = (table, row) => { for (const [column, value] of Object.entries(row)) (table[column] ??= []).push(value); };

/** The rows of a sweep's failures and worst findings: faults of the sample, and passes of its worst. */
function addLists(report, names, { failures: most, law }) {
  const f = report.findings;
  const verdictOf = (i) => report.names.verdict[f.verdict[i]];
  const own = f.question.map((_, i) => i).filter((i) => f.oracle[i] < names.oracle.length).sort((a, b) => f.share[b] - f.share[a]);
  const rowOf = (i) => ({ question: f.question[i], family: f.question[i] % 2, pair: names.pair.indexOf(report.questions[f.question[i]].pair ?? ""), oracle: f.oracle[i], measure: law ? names.measure.indexOf(report.names.measure[f.measure[i]].name) : 0, law: law ? names.law.indexOf(report.texts[f.law[i]]) : -1, value: f.value[i], share: f.share[i] });
  const [failures, worst] = [{}, {}];
  own.filter((i) => ["fail", "known"].includes(verdictOf(i)) && rowOf(i).measure >= 0).slice(0, most)
    .forEach((i, k) => add(failures, { ...rowOf(i), verdict: 1, grade: names.grade.length - 1, proof: k === 0 ? hostile[1] : report.texts[f.proof[i]], is_new: k % 2 === 1 }));
  own.filter((i) => rowOf(i).measure >= 0 && ["pass", "known"].includes(verdictOf(i)) && (law || report.names.measure[f.measure[i]].name === "separation_error")).slice(0, 400)
    .forEach((i, k) => add(worst, { ...rowOf(i), verdict: verdictOf(i) === "pass" ? 0 : 1, grade: verdictOf(i) === "pass" ? -1 : names.grade.length - 1, tolerance: 1e-12, tolerances: k === 0 ? "inf" : Math.abs(f.share[i]) * 1e12 }));
  return { failures, worst };
}

/** The page of a sweep: two families, two pairs, and the failures of the sample's contact questions. */
export function makeSweepSample() {
  const sample = makeSample({ contacts: 30, worlds: 0, findings: 600 });
  const { report } = sample;
  const names = { oracle: report.oracles.slice(0, 8).map((o) => o.name), family: ["random", "edge_edge"], pair: ["sphere–box", "box–box"], measure: ["separation_error", "excess"], law: [], verdict: ["pass", "fail", "unsupported", "crashed"], grade: ["over 1e-6", "over 10 %"] };
  const [answers, findings, sketches] = [{}, {}, {}];
  names.oracle.forEach((_, oracle) => names.pair.forEach((_p, pair) => {
    names.family.forEach((_f, family) => {
      if (oracle === 7) { add(answers, { family, pair, oracle, verdict: 2, grade: -1, count: 1000 }); return; }
      add(answers, { family, pair, oracle, verdict: 0, grade: -1, count: 900 });
      // The bullets (1, 2 and 3) are wrong in the second family.
      add(answers, { family, pair, oracle, verdict: 1, grade: family, count: family === 1 && oracle >= 1 && oracle <= 3 ? 100 : 1 });
      if (pair === 0) for (const measure of [0, 1]) { add(findings, { family, oracle, measure, law: -1, verdict: 0, grade: -1, count: 1500 }); add(findings, { family, oracle, measure, law: -1, verdict: 1, grade: 1, count: measure ? 500 : 0 }); }
    });
    if (oracle < 7) for (const measure of [0, 1]) add(sketches, { pair, oracle, measure, law: -1, zeros: 500, infinite: 0, bins: [-64, 400, -63, 90, -4 - oracle, 10] });
  }));
  report.questions[0].own = true;
  report.ledger = [];
  report.findings.ledger = report.findings.ledger.map(() => -1);
  report.sweep = { kind: "contact", settings: [{ name: "touchstone", value: hostile[0] }], asked: 2000, failed: 614, kept: 4321, answers, findings, bins_per_decade: 4, sketches, ...addLists(report, names, { failures: 70, law: false }), names };
  return sample;
}

/** The page of a sweep of worlds: two families, three laws. */
export function makeWorldSweepSample() {
  const sample = makeSample({ contacts: 0, worlds: 12, findings: 600 });
  const { report } = sample;
  const names = { oracle: report.oracles.filter((o) => o.worlds).map((o) => o.name), family: ["drops", "rods"], pair: [], measure: ["position_error", "energy_drift", "stability"], law: ["conserves_energy", "bounce_series"], verdict: ["pass", "fail"], grade: ["over 10 %"] };
  const [answers, findings, sketches] = [{}, {}, {}];
  names.oracle.forEach((_, oracle) => names.family.forEach((_f, family) => {
    add(answers, { family, pair: -1, oracle, verdict: 0, grade: -1, count: 90 });
    add(answers, { family, pair: -1, oracle, verdict: 1, grade: 0, count: 10 });
    // One energy in five is lost among the rods.
    [[1, 0, family ? 20 : 0], [0, 1, 10]].forEach(([measure, law, wrong]) => {
      add(findings, { family, oracle, measure, law, verdict: 0, grade: -1, count: 100 - wrong });
      if (wrong) add(findings, { family, oracle, measure, law, verdict: 1, grade: 0, count: wrong });
      if (family === 0) add(sketches, { pair: -1, oracle, measure, law, zeros: 5, infinite: 0, bins: [-20, 150, -3, 45] });
    });
  }));
  report.ledger = [];
  report.findings.ledger = report.findings.ledger.map(() => -1);
  // The first oracle is one that simulates, and so are all that were swept.
  report.sweep = { kind: "world", settings: [], asked: 200, failed: 20 * names.oracle.length, kept: 30, answers, findings, bins_per_decade: 4, sketches, failures: {}, worst: {}, names };
  const own = report.oracles.map((o) => names.oracle.indexOf(o.name));
  const keep = report.findings.oracle.map((o) => own[o] >= 0);
  Object.assign(report.sweep, addLists({ ...report, findings: Object.fromEntries(Object.entries(report.findings).map(([key, column]) => [key, (key === "oracle" ? column.map((o) => own[o]) : column).filter((_, i) => keep[i])])) }, names, { failures: 70, law: true }));
  return sample;
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
