const prefixes: [number, string][] = [[1e3, "k"], [1, ""], [1e-2, "c"], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"]];

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

/** Writes a length with the prefix that suits it: "4.81 cm", "13 µm", "2e-16 m". */
export function length(metres: number): string {
  const size = Math.abs(metres);
  if (size === 0 || !Number.isFinite(size) || size < 1e-9 || size >= 1e6) return `${digits(metres)} m`;
  const [unit, prefix] = prefixes.find(([u]) => size >= u * 0.9995) ?? prefixes[prefixes.length - 1];
  return `${digits(metres / unit)} ${prefix}m`;
}

/** Writes a quantity of a measure. Texts ("inf", "nan") stand for what JSON cannot hold. */
export function quantity(value: number | string, unit: string): string {
  const number = numberOf(value);
  if (unit === "m") return length(number);
  return unit === "" ? digits(number) : `${digits(number)} ${unit}`;
}

export function numberOf(value: number | string): number {
  if (typeof value === "number") return value;
  return value === "inf" ? Infinity : value === "-inf" ? -Infinity : NaN;
}

/** Writes a share: "5 %", "0.02 %", "2e-16", "51 ×". */
export function ratio(value: number): string {
  const size = Math.abs(value);
  if (size >= 10) return `${digits(value, 2)} ×`;
  return size >= 1e-4 ? `${digits(value * 100, 2)} %` : digits(value, 2);
}

/** Writes a share of the size of a question: "5 % of the size", "51 × the size". */
export const share = (value: number): string => (Math.abs(value) >= 10 ? `${ratio(value)} the size` : `${ratio(value)} of the size`);

export const seconds = (time: number): string => `${time.toFixed(3)} s`;

/** "1 finding", "2 findings". */
export const counted = (count: number, noun: string, plural = noun + "s"): string =>
  `${count.toLocaleString("en")} ${count === 1 ? noun : plural}`;

/** "separation_error" reads as "separation error". */
export const spaced = (name: string): string => name.replaceAll("_", " ");

/** The first letter as a capital. */
export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);
