const prefixes: [number, string][] = [[1, ""], [1e-2, "c"], [1e-3, "m"], [1e-6, "µ"]];

/** Rounds to three digits: "0.0481", "4.2e-16". */
export function digits(value: number, count = 3): string {
  if (Number.isNaN(value)) return "not a number";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text = size >= 1e-3 && size < 1e5 ? String(Number(value.toPrecision(count)))
    : value.toExponential(count - 1).replace(/\.?0+e/, "e").replace("e+", "e");
  return text.replace(/^-/, "−");
}

/** Most digits of a number that is read beside others: doubles that differ by less are alike to a reader. */
const mostDigits = 12;

/** Writes numbers that are read side by side: each to the fewest digits, `least` or more, with which all that differ read differently. */
export function apart(values: number[], least = 3): string[] {
  const different = new Set(values).size;
  let count = least;
  while (count < mostDigits && new Set(values.map((v) => digits(v, count))).size < different) ++count;
  return values.map((v) => digits(v, count));
}

/** Rounds as the sentences of the program do (reports/text/si_quantity.cc), so that a number is written in one way wherever it is read: to two
 * digits, from 100 on to three. */
export function short(value: number): string {
  const size = Math.abs(value);
  if (!Number.isFinite(value) || value === 0) return digits(value);
  if (size >= 99.5 && size < 1e6) return String(Math.round(Number(value.toPrecision(3)))).replace(/^-/, "−");
  const rounded = Math.abs(Number(value.toPrecision(2)));
  const text = rounded >= 1e-4 && rounded < 1e6 ? String(Number(value.toPrecision(2))) : value.toExponential(1).replace(".0e", "e").replace("e+", "e");
  return text.replace(/^-/, "−");
}

/** Writes a length with the prefix that suits it: "4.8 cm", "13 µm", "2e-16 m". */
export function length(metres: number): string {
  const size = Math.abs(metres);
  const prefix = Number.isFinite(size) ? prefixes.find(([unit]) => size >= 0.995 * unit) : undefined;
  return prefix ? `${short(metres / prefix[0])} ${prefix[1]}m` : `${short(metres)} m`;
}

/** Writes a length to three digits, as proofs do: "62.3 cm". */
export function precise(metres: number): string {
  const size = Math.abs(metres);
  const prefix = Number.isFinite(size) ? prefixes.find(([unit]) => size >= 0.9995 * unit) : undefined;
  return prefix ? `${digits(metres / prefix[0])} ${prefix[1]}m` : `${digits(metres)} m`;
}

/** Writes a quantity of a measure. Texts ("inf", "nan") stand for what JSON cannot hold. */
export function quantity(value: number | string, unit: string): string {
  const number = numberOf(value);
  if (unit === "m") return length(number);
  return unit === "" ? short(number) : `${short(number)} ${unit}`;
}

export function numberOf(value: number | string): number {
  if (typeof value === "number") return value;
  return value === "inf" ? Infinity : value === "-inf" ? -Infinity : NaN;
}

/** Writes a share: "5 %", "0.02 %", "2e-16", "4 ×". */
export function ratio(value: number): string {
  const size = Math.abs(value);
  if (size >= 1.05) return `${short(value)} ×`;
  return size >= 1e-4 ? `${short(value * 100)} %` : short(value);
}

/** Writes a share of `whole`: "5 % of the smaller body", "4 times the smaller body". */
export const share = (value: number, whole: string): string => (Math.abs(value) >= 1.05 ? `${short(value)} times ${whole}` : `${ratio(value)} of ${whole}`);

export const seconds = (time: number): string => `${time.toFixed(3)} s`;

/** "1 finding", "2 findings". */
export const counted = (count: number, noun: string, plural = noun + "s"): string =>
  `${count.toLocaleString("en")} ${count === 1 ? noun : plural}`;

/** "separation_error" reads as "separation error". */
export const spaced = (name: string): string => name.replaceAll("_", " ");

/** The first letter as a capital. */
export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** A name in quotation marks: users choose the names of bodies, and in a sentence any word may be one. */
export const quoted = (name: string): string => `“${name}”`;
