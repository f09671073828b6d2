import { describe, expect, it } from "vitest";
import { parseAddress, address, toggled } from "../../src/address";
import { bandOf, bandOfNamed, bands, faultBands } from "../../src/bands";
import type { Report } from "../../src/data";
import { bandsOf, findMatches, orderBy } from "../../src/filter";
import { makeRun } from "../../src/run";
import { alike, synonymsOf } from "../../src/synonyms";
import { indexed, makeSearch, wordsOf } from "../../src/search";
import { makeSample } from "../sample/make.mjs";

const sample = makeSample({ contacts: 60, worlds: 4, findings: 2000 });
const run = makeRun({ report: sample.report as unknown as Report, blob: Uint8Array.from(sample.blob.bytes) });
const { findings } = run.report;

/** The findings that contain all words, found the slow way. */
function slowly(query: string): number[] {
  return findings.question.map((_, i) => i).filter((i) => {
    const entry = run.report.ledger[findings.ledger[i]];
    const question = run.report.questions[findings.question[i]];
    const text = indexed([question.id, question.title, question.pair, run.report.oracles[findings.oracle[i]].name, run.report.oracles[findings.oracle[i]].library, run.report.names.measure[findings.measure[i]].name,
      run.report.names.verdict[findings.verdict[i]], run.report.names.cause[findings.cause[i]], run.text(findings.law[i]), run.text(findings.proof[i]), run.text(findings.cause_because[i]), run.text(findings.shipped_because[i]), entry?.fault, entry?.reason, entry?.upstream].join(" "));
    return wordsOf(query).every((w) => synonymsOf(w.slice(1)).some((s) => text.includes(" " + s)));
  });
}

describe("long numbers", () => {
  it("are known by their first six digits", () => {
    expect(indexed("n = (0.8342246834679924, 1.5216404033822662e-12)")).toBe(" n 0 834224 1 521640 12");
    expect(wordsOf("0.8342246834679924")).toEqual([" 0", " 834224"]);
  });
});

describe("search", () => {
  it("finds the beginnings of words, and of the parts of compound ones", () => {
    const text = indexed("btGjkEpa2 in box_box: a separated pair");
    for (const query of ["EPA", "btgjk", "gjk", "box", "SEPAR"]) expect(wordsOf(query).every((w) => text.includes(w)), query).toBe(true);
    for (const query of ["epar", "jk", "ox"]) expect(wordsOf(query).every((w) => text.includes(w)), query).toBe(false);
  });

  it("does not find the proofs of separated pairs by EPA", () => {
    const found = makeSearch(run.report).find("EPA")!;
    const separated = makeSearch(run.report).find("separated")!;
    expect([...separated].some((hit, i) => hit === 1 && found[i] === 0)).toBe(true);
    expect([...found].some((hit) => hit === 1)).toBe(true);
  });

  it.each(["EPA", "bullet known", "world precision", "shallower edge", "case_0012", "right to left", "script attacked", "nothing has these words"])("finds what a slow search finds: %s", (query) => {
    const found = run.search.find(query)!;
    expect([...found.keys()].filter((i) => found[i])).toEqual(slowly(query));
  });

  it("knows the words that the field has for one thing", () => {
    const { report, blob } = makeSample({ contacts: 20, worlds: 4, findings: 600 });
    report.ledger[3].fault = "Fast bodies pass through each other.";
    const tunnelling = makeRun({ report: report as unknown as Report, blob: Uint8Array.from(blob.bytes) });
    for (const query of ["tunnel", "tunnelling", "tunnels fast"]) {
      const found = tunnelling.search.find(query)!;
      expect([...found.keys()].filter((i) => found[i]), query).toEqual(report.findings.ledger.map((entry: number, i: number) => (entry === 3 ? i : -1)).filter((i: number) => i >= 0));
    }
    expect(synonymsOf("depth")).toContain("penetrat");
    expect(synonymsOf("restitution")).toContain("bounc");
    expect(synonymsOf("hang")).toContain("timed out");
    // Letters of the first typing, and the name of an engine, have no synonyms.
    for (const word of ["tun", "bullet", "ode", "e"]) expect(synonymsOf(word)).toEqual([word]);
    expect(tunnelling.search.matches("a body that passes through another", "tunnel")).toBe(true);
  });

  it("suggests words that are spelled alike", () => {
    expect(alike("frictoin", ["friction", "fraction", "bounce"])[0]).toBe("friction");
    expect(run.search.alike("bulet")).toContain("bullet");
    expect(run.search.alike("xqzwvk")).toEqual([]);
  });

  it("is no filter without words", () => {
    expect(run.search.find(" ?! ")).toBeNull();
  });
});

describe("filters", () => {
  it("show the faults, the gravest first, unless an address asks for more", () => {
    const { found } = findMatches(run, new URLSearchParams());
    expect(found.length).toBe([...run.band].filter((b) => b < faultBands.length).length);
    for (let i = 1; i < found.length; ++i) expect(run.band[found[i]]).toBeGreaterThanOrEqual(run.band[found[i - 1]]);
  });

  it("add up, and their values are alternatives", () => {
    const { found, perBand } = findMatches(run, new URLSearchParams("oracle=bullet,ode&group=world/bounce&band=all"));
    expect(found.length).toBeGreaterThan(0);
    expect(found.length).toBe(perBand.reduce((a, b) => a + b));
    for (const i of found) {
      expect(["bullet", "ode"]).toContain(run.report.oracles[findings.oracle[i]].name);
      expect(run.report.questions[findings.question[i]].group).toBe("world/bounce");
    }
  });

  it("count each band as if no band were chosen", () => {
    expect(findMatches(run, new URLSearchParams("band=grave")).perBand).toEqual(findMatches(run, new URLSearchParams("band=all")).perBand);
  });

  it("sort by every column, falling or rising", () => {
    const values = findMatches(run, new URLSearchParams("sort=share")).found.map((i) => findings.share[i]);
    expect(values).toEqual([...values].sort((a, b) => b - a));
    expect(findMatches(run, new URLSearchParams("sort=share&down=0")).found.map((i) => findings.share[i])).toEqual([...values].reverse());
    expect(new Set(orderBy(run, "oracle")).size).toBe(findings.question.length);
  });

  it("pass over words that they do not know", () => {
    expect(bandsOf(new URLSearchParams("band=terrible"))).toEqual(bandsOf(new URLSearchParams()));
    expect(findMatches(run, new URLSearchParams("oracle=nobody")).found).toEqual([]);
    expect(() => findMatches(run, new URLSearchParams("sort=constructor"))).not.toThrow();
  });
});

describe("a band", () => {
  it("is that of the grade of a fault, and of the verdict where there is none", () => {
    expect(bandOf("fail", 4)).toBe("grave");
    expect(bandOf("known", 5)).toBe("touch");
    expect(bandOf("known", 1)).toBe("rounding");
    expect(bandOfNamed("fail", "over 10 %")).toBe("grave");
    expect(bandOf("crashed", 6)).toBe("crash");
    expect(bandOf("pass", 0)).toBe("passed");
    expect(bands.map((b) => b)).toContain(bandOf("undecidable", 3));
  });
});

describe("an address", () => {
  it("is read as it was written, whatever an id holds", () => {
    const id = "mine/100% <b>?a=b#c";
    const { path, query } = parseAddress(address(["s", id], { q: "a&b", none: "" }));
    expect(path).toEqual(["s", id]);
    expect([...query]).toEqual([["q", "a&b"]]);
    expect(parseAddress("#/s/100%").path).toEqual(["s", "100%"]);
  });

  it("toggles one of several values", () => {
    const once = toggled(new URLSearchParams("band=grave"), "band", "small");
    expect(once.get("band")).toBe("grave,small");
    expect(toggled(once, "band", "grave").get("band")).toBe("small");
  });
});
