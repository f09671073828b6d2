import { describe, expect, it } from "vitest";
import type { Report } from "../../src/data";
import { cellsOf, duration, sumsByOracle } from "../../src/timings";

const report = {
  oracles: [{ name: "bullet" }, { name: "ode" }], questions: [{ id: "contact/b" }, { id: "world/a" }, { id: "contact/a" }],
  seconds: [[1e-6, 3e-6], [null, 2], [5e-6, 0]],
} as unknown as Report;
const named = (cells: ReturnType<typeof cellsOf>): string[] => cells.map((c) => `${report.questions[c.question].id} ${report.oracles[c.oracle].name}`);

describe("cellsOf", () => {
  it("lists the longest first, and none that was not asked", () => {
    expect(named(cellsOf(report))).toEqual(["world/a ode", "contact/a bullet", "contact/b ode", "contact/b bullet", "contact/a ode"]);
  });
  it("sorts by name, the longest of a name first, and either way", () => {
    expect(named(cellsOf(report, "", "question"))).toEqual(["contact/a bullet", "contact/a ode", "contact/b ode", "contact/b bullet", "world/a ode"]);
    expect(named(cellsOf(report, "", "oracle", true))[0]).toBe("world/a ode");
    expect(named(cellsOf(report, "", "seconds", true))[0]).toBe("contact/a ode");
  });
  it("lists one oracle", () => {
    expect(named(cellsOf(report, "bullet"))).toEqual(["contact/a bullet", "contact/b bullet"]);
  });
  it("is empty for reports without times", () => {
    expect(cellsOf({ ...report, seconds: undefined })).toEqual([]);
  });
});

describe("sumsByOracle", () => {
  it("adds up, the largest first", () => {
    expect(sumsByOracle(cellsOf(report))).toEqual([{ oracle: 1, seconds: 2 + 3e-6 }, { oracle: 0, seconds: 6e-6 }]);
  });
});

describe("duration", () => {
  it("has the unit that suits it", () => {
    expect([12.34, 0.9996, 0.0456, 2e-6, 1.2e-7, 0].map(duration)).toEqual(["12.3 s", "1 s", "45.6 ms", "2 µs", "0.12 µs", "0 s"]);
  });
});
