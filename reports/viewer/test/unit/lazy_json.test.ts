import { describe, expect, it } from "vitest";
import { parseLazily } from "../../src/lazy_json";

const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);
const read = (value: unknown): unknown => JSON.parse(JSON.stringify(parseLazily(bytesOf(JSON.stringify(value)), ["columns"], ["rows"], "texts").value));

describe("JSON that is parsed when it is read", () => {
  const long = Array.from({ length: 400 }, (_, i) => i - 200);
  const hostile = ["\"],\"", "\\", "\\\\\"", "]}", "é – µ", "\u2028", ""];
  it("is what the browser reads at once, whatever is in its texts", () => {
    const whole = { a: 1, long, columns: { x: long, y: ["inf", ...long, "]"], deep: [[1, [2]], ...long] }, rows: [{ id: "}", big: long }, {}, { texts: hostile }], texts: hostile, none: null, yes: true, empty: {} };
    expect(read(whole)).toEqual(whole);
    expect(read({})).toEqual({});
  });
  it("gives single texts", () => {
    const { text } = parseLazily(bytesOf(JSON.stringify({ texts: hostile })), [], [], "texts");
    expect(hostile.map((_, i) => text!(i))).toEqual(hostile);
    expect(text!(99)).toBe("");
  });
  it("is refused as the browser refuses it", () => {
    for (const broken of ["{\"a\": [1, 2", "[1", "{\"a\" 1}", "{} x", ""]) expect(() => parseLazily(bytesOf(broken), [], [], "texts"), broken).toThrow(SyntaxError);
  });
});
