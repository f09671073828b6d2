import { deflateSync } from "node:zlib";
import { describe, expect, it } from "vitest";
import { DataError, decodeTrack, parseData, readReportData } from "../../src/decode";
import { Blob, fillPage, pack, placeholder } from "../sample/encode.mjs";
import { makeSample } from "../sample/make.mjs";

const base64 = (bytes: Buffer): string => deflateSync(bytes).toString("base64");

describe("the data of a page", () => {
  it("are read back as they were written, strings of any kind included", async () => {
    const { report, blob } = makeSample({ contacts: 10, worlds: 2, findings: 200 });
    const read = await readReportData(base64(pack(report, blob)));
    expect(read.report).toEqual(JSON.parse(JSON.stringify(report)));
    expect(read.blob.length).toBe(blob.bytes.length);
  });

  it("of a newer version are refused, with both versions named", () => {
    expect(() => parseData(pack({ any: 1 }, new Blob(), 2))).toThrow("this page reads data of version 1; these have version 2");
  });

  it("that are damaged are refused in words", async () => {
    const bytes = pack({ any: 1 });
    await expect(readReportData("")).rejects.toThrow("holds no report");
    await expect(readReportData("***")).rejects.toThrow("not base64");
    await expect(readReportData(Buffer.from("no deflate").toString("base64"))).rejects.toThrow("do not inflate");
    expect(() => parseData(bytes.subarray(0, bytes.length - 3))).toThrow("cut short");
    expect(() => parseData(Buffer.from("XSRD00000000"))).toThrow(DataError);
  });

  it("of the same sample are the same bytes", () => {
    const one = makeSample({ contacts: 9, worlds: 1, findings: 100 });
    const two = makeSample({ contacts: 9, worlds: 1, findings: 100 });
    expect(pack(one.report, one.blob).equals(pack(two.report, two.blob))).toBe(true);
  });
});

describe("a track", () => {
  it("keeps each channel to half of its scale, signs and integers beyond 32 bits included", () => {
    const blob = new Blob();
    const channels = [[0, -1.5, 2.25, 1e-3], [1e12, -1e12, 3, 5e11], [7, 7, 7, 7]];
    const scale = [1e-3, 1e-2, 0.5];
    blob.track([[1], [2]], [1, 1]);
    const track = blob.track(channels, scale);
    decodeTrack(Uint8Array.from(blob.bytes), track).forEach((decoded, c) =>
      decoded.forEach((value, i) => expect(Math.abs(value - channels[c][i])).toBeLessThanOrEqual(scale[c] / 2 + Math.abs(channels[c][i]) * 2 ** -52)));
  });

  it("that runs past the end of the data is refused", () => {
    const blob = new Blob();
    const track = blob.track([[1, 2, 3]], [1]);
    expect(() => decodeTrack(Uint8Array.from(blob.bytes).subarray(0, 2), track)).toThrow("cut short");
  });
});

describe("the page", () => {
  it("is filled at its one place", () => {
    expect(fillPage(`<p>${placeholder}</p>`, Buffer.from("a"))).toMatch(/^<p><script type="application\/octet-stream" id="report-data">[A-Za-z0-9+/=]+<\/script><\/p>$/);
    expect(() => fillPage(placeholder + placeholder, Buffer.from("a"))).toThrow("once");
  });
});
