import { h } from "./dom";

function download(name: string, blob: Blob): void {
  const url = URL.createObjectURL(blob);
  const link = h("a", { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

/** A cell of a table of comma-separated values. A leading sign that a spreadsheet would run as a formula is disarmed. */
function cell(value: string | number): string {
  const text = typeof value === "string" && /^[=+@\t\r-]/.test(value) ? `'${value}` : String(value);
  return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

export const csv = (rows: (string | number)[][]): string => rows.map((row) => row.map(cell).join(",")).join("\r\n") + "\r\n";

export const downloadCsv = (name: string, rows: (string | number)[][]): void =>
  download(name, new Blob([csv(rows)], { type: "text/csv;charset=utf-8" }));

export const downloadText = (name: string, text: string): void => download(name, new Blob([text], { type: "text/plain;charset=utf-8" }));

export function downloadPicture(name: string, picture: Blob | null): void {
  if (picture) download(name, picture);
}

/** A name for a file from an id. */
export const fileName = (id: string, ending: string): string => `${id.replace(/[^\w.-]+/g, "_").slice(0, 120)}.${ending}`;
