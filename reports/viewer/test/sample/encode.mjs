// Writes the data of a report as the program does: see src/data.ts for the form.
import { deflateSync } from "node:zlib";

/** Collects tracks. */
export class Blob {
  bytes = [];

  /** Adds channels of one length; `scale` has one number for each. */
  track(channels, scale) {
    const at = this.bytes.length;
    channels.forEach((channel, c) => {
      let before = 0;
      for (const value of channel) {
        const integer = Math.round(value / scale[c]);
        const step = integer - before;
        before = integer;
        let zigzag = step < 0 ? -2 * step - 1 : 2 * step;
        while (zigzag >= 128) {
          this.bytes.push((zigzag % 128) + 128);
          zigzag = Math.floor(zigzag / 128);
        }
        this.bytes.push(zigzag);
      }
    });
    return { at, samples: channels[0].length, scale };
  }
}

/** The bytes before they are deflated. */
export function pack(report, blob = new Blob(), version = 1) {
  const json = Buffer.from(JSON.stringify(report), "utf8");
  const head = Buffer.alloc(12);
  head.write("TSRD", 0, "latin1");
  head.writeUInt32LE(version, 4);
  head.writeUInt32LE(json.length, 8);
  return Buffer.concat([head, json, Buffer.from(blob.bytes)]);
}

export const placeholder = '<script type="application/octet-stream" id="report-data"></script>';

/** The page with its data, as the program makes it from the built viewer. */
export function fillPage(page, packed) {
  if (page.split(placeholder).length !== 2) throw new Error("the page must hold the place for the data once");
  return page.replace(placeholder, placeholder.replace("></", `>${deflateSync(packed, { level: 9 }).toString("base64")}</`));
}
