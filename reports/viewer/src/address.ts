/** The state of the page: a path and its filters. Everything that a reader can share is in it. */
export interface Address { path: string[]; query: URLSearchParams }

/** Reads the part of an address behind the "#": "/s/contact%2Fbox?tab=file". */
export function parseAddress(hash: string): Address {
  const text = hash.replace(/^#/, "");
  const mark = text.indexOf("?");
  const path = mark < 0 ? text : text.slice(0, mark);
  return {
    path: path.split("/").filter((part) => part !== "").map(decode),
    query: new URLSearchParams(mark < 0 ? "" : text.slice(mark + 1)),
  };
}

function decode(part: string): string {
  try {
    return decodeURIComponent(part);
  } catch {
    return part;  // A stray "%" typed by hand.
  }
}

/** Writes an address: `address(["s", id], { tab: "file" })`. Empty values are left out. */
export function address(path: string[], query: Record<string, string> | URLSearchParams = {}): string {
  const entries = query instanceof URLSearchParams ? [...query] : Object.entries(query);
  const rest = new URLSearchParams(entries.filter(([, value]) => value !== "")).toString();
  return "#/" + path.map(encodeURIComponent).join("/") + (rest ? "?" + rest : "");
}

/** The address of a question. */
export const questionAddress = (id: string, query: Record<string, string> = {}): string => address(["s", id], query);

/** The values of a key that may have several, separated by commas. */
export function valuesOf(query: URLSearchParams, key: string): string[] {
  return (query.get(key) ?? "").split(",").filter((value) => value !== "");
}

/** The query with one value of a key switched on or off. */
export function toggled(query: URLSearchParams, key: string, value: string): URLSearchParams {
  const values = valuesOf(query, key);
  const next = values.includes(value) ? values.filter((v) => v !== value) : [...values, value];
  return withValue(query, key, next.join(","));
}

export function withValue(query: URLSearchParams, key: string, value: string): URLSearchParams {
  const result = new URLSearchParams(query);
  if (value === "") result.delete(key);
  else result.set(key, value);
  return result;
}
