import type { Report, Track } from "./data";

/** A report and the bytes that its tracks refer to. */
export interface ReportData { report: Report; blob: Uint8Array }

/** A defect of the data that the reader can be told. */
export class DataError extends Error {}

const magic = "TSRD";
const version = 1;
const headerBytes = 12;

export function bytesOfBase64(base64: string): Uint8Array<ArrayBuffer> {
  let text: string;
  try {
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
  const report = JSON.parse(new TextDecoder().decode(bytes.subarray(headerBytes, end))) as Report;
  for (const cluster of report.clusters ?? []) {
    cluster.title ??= cluster.sentence ?? "";
    cluster.extent ??= "";
  }
  return { report, blob: bytes.subarray(end) };
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
