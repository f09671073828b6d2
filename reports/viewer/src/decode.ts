import type { Report, Track } from "./data";
import { parseLazily } from "./lazy_json";

/** A report and the bytes that its tracks refer to. Its large parts are parsed when they are first read.
 * @param text one of the texts of the report, without parsing them all */
export interface ReportData { report: Report; blob: Uint8Array; text?: (index: number) => string }

/** A defect of the data that the reader can be told. */
export class DataError extends Error {}

const magic = "TSRD";
const version = 1;
const headerBytes = 12;

export function bytesOfBase64(base64: string): Uint8Array<ArrayBuffer> {
  // The browser's own decoder, where it has one, makes no text of the bytes first.
  const { fromBase64 } = Uint8Array as unknown as { fromBase64?: (text: string) => Uint8Array<ArrayBuffer> };
  let text: string;
  try {
    if (fromBase64) return fromBase64.call(Uint8Array, base64.trim());
    text = atob(base64.trim());
  } catch {
    throw new DataError("the data of this page are not base64");
  }
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

export async function inflate(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  try {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch {
    throw new DataError("the data of this page are damaged: they do not inflate");
  }
}

/** Reads inflated data. @throws DataError if they are not of a version that this page reads. */
export function parseData(bytes: Uint8Array): ReportData {
  if (bytes.length < headerBytes || new TextDecoder("latin1").decode(bytes.subarray(0, 4)) !== magic) {
    throw new DataError("the data of this page are not those of a report of Touchstone");
  }
  const header = new DataView(bytes.buffer, bytes.byteOffset, headerBytes);
  const found = header.getUint32(4, true);
  if (found !== version) throw new DataError(`this page reads data of version ${version}; these have version ${found}`);
  const end = headerBytes + header.getUint32(8, true);
  if (end > bytes.length) throw new DataError("the data of this page are cut short");
  const { value, text } = parseLazily(bytes.subarray(headerBytes, end), ["findings", "proofs", "cited", "studies"], ["questions"], "texts");
  const report = value as Report;
  for (const cluster of report.clusters ?? []) {
    cluster.title ??= cluster.sentence ?? "";
    cluster.extent ??= "";
  }
  return { report, blob: bytes.subarray(end), ...(text && { text }) };
}

export async function readReportData(base64: string): Promise<ReportData> {
  if (base64.trim() === "") {
    throw new DataError("this page holds no report: `touchstone run --out DIR` writes one that does");
  }
  return parseData(await inflate(bytesOfBase64(base64)));
}

/** Returns the channels of a track. Channel c has the numbers of `scale[c]`.
 * @throws DataError if the track runs past the end of the blob. */
export function decodeTrack(blob: Uint8Array, track: Track): Float64Array[] {
  let at = track.at;
  return track.scale.map((scale) => {
    const channel = new Float64Array(track.samples);
    let sum = 0;
    for (let i = 0; i < track.samples; ++i) {
      // Not by shifts, which would cut the integer to 32 bits.
      let value = 0;
      let weight = 1;
      let byte: number;
      do {
        if (at >= blob.length) throw new DataError("a track of the data is cut short");
        byte = blob[at++];
        value += (byte & 0x7f) * weight;
        weight *= 128;
      } while (byte >= 0x80);
      sum += value % 2 === 0 ? value / 2 : -(value + 1) / 2;
      channel[i] = sum * scale;
    }
    return channel;
  });
}
