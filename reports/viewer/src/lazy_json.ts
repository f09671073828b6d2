/** Parses only the parts of a JSON text that are read. A report has tens of megabytes, and a screen needs a few of them. */

const [quote, backslash, open, close, openBrace, closeBrace, comma, colon] = [...'"\\[]{},:'].map((c) => c.charCodeAt(0));

/** A defect of the JSON: the caller parses all of it, and gets the error of the browser. */
class NotPlain extends Error {}

const isSpace = (c: number): boolean => c === 32 || c === 10 || c === 13 || c === 9;

function skipSpace(bytes: Uint8Array, at: number): number {
  while (isSpace(bytes[at])) ++at;
  return at;
}

/** The place after a string that begins at `at`. */
function skipString(bytes: Uint8Array, at: number): number {
  for (let end = bytes.indexOf(quote, at + 1); end >= 0; end = bytes.indexOf(quote, end + 1)) {
    let slashes = 0;
    while (bytes[end - 1 - slashes] === backslash) ++slashes;
    if (slashes % 2 === 0) return end + 1;
  }
  throw new NotPlain();
}

const isNumeric = (c: number): boolean => (c >= 48 && c <= 57) || c === 45;
const isBefore = (at: number, other: number): boolean => other < 0 || at < other;

/** The place after the value that begins at `at`. */
function skipValue(bytes: Uint8Array, at: number): number {
  const first = bytes[at];
  if (first === quote) return skipString(bytes, at);
  if (first !== open && first !== openBrace) {
    while (at < bytes.length && bytes[at] !== comma && bytes[at] !== close && bytes[at] !== closeBrace && !isSpace(bytes[at])) ++at;
    return at;
  }
  for (let depth = 0; at < bytes.length;) {
    const c = bytes[at];
    if (c === quote) { at = skipString(bytes, at); continue; }
    ++at;
    if (c === open || c === openBrace) {
      ++depth;
      // Long rows of numbers are passed over by the browser's own search.
      if (c === open && isNumeric(bytes[at])) {
        const end = bytes.indexOf(close, at);
        if (end - at > 64 && isBefore(end, bytes.indexOf(quote, at)) && isBefore(end, bytes.indexOf(open, at))) at = end;
      }
    }
    else if ((c === close || c === closeBrace) && --depth === 0) return at;
  }
  throw new NotPlain();
}

const decoder = new TextDecoder();
const parse = (bytes: Uint8Array, [from, to]: Span): unknown => JSON.parse(decoder.decode(bytes.subarray(from, to)));

/** The bytes of a value. */
export type Span = [from: number, to: number];

/** Members of an object, in their order; the last of two with one name counts, as it does for the browser. */
function membersOf(bytes: Uint8Array, at: number): { members: Map<string, Span>; end: number } {
  const members = new Map<string, Span>();
  if (bytes[at] !== openBrace) throw new NotPlain();
  at = skipSpace(bytes, at + 1);
  while (bytes[at] !== closeBrace) {
    const key = skipString(bytes, at);
    const name = parse(bytes, [at, key]) as string;
    at = skipSpace(bytes, key);
    if (bytes[at] !== colon) throw new NotPlain();
    const from = skipSpace(bytes, at + 1);
    const to = skipValue(bytes, from);
    members.set(name, [from, to]);
    at = skipSpace(bytes, to);
    if (bytes[at] === comma) at = skipSpace(bytes, at + 1);
    else if (bytes[at] !== closeBrace) throw new NotPlain();
  }
  return { members, end: at + 1 };
}

/** The elements of an array. */
function elementsOf(bytes: Uint8Array, [from]: Span): Span[] {
  const elements: Span[] = [];
  if (bytes[from] !== open) throw new NotPlain();
  let at = skipSpace(bytes, from + 1);
  while (bytes[at] !== close) {
    const to = skipValue(bytes, at);
    elements.push([at, to]);
    at = skipSpace(bytes, to);
    if (bytes[at] === comma) at = skipSpace(bytes, at + 1);
    else if (bytes[at] !== close) throw new NotPlain();
  }
  return elements;
}

/** Values of fewer bytes are parsed at once. */
const small = 512;

/** An object whose large members are parsed when they are first read. To the reader it is an object like any other. */
function lazyObject(bytes: Uint8Array, members: Map<string, Span>, made: Record<string, () => unknown> = {}): object {
  const object = {};
  for (const [name, span] of members) {
    const make = made[name] ?? ((): unknown => parse(bytes, span));
    if (made[name] === undefined && span[1] - span[0] < small) Object.defineProperty(object, name, { value: make(), writable: true, enumerable: true, configurable: true });
    else {
      const keep = (value: unknown): unknown => { Object.defineProperty(object, name, { value, writable: true, enumerable: true, configurable: true }); return value; };
      Object.defineProperty(object, name, { get: () => keep(make()), set: keep, enumerable: true, configurable: true });
    }
  }
  return object;
}

/** Parses an object: members named in `columns` are objects with lazy members of their own, those in `rows` arrays of such objects.
 * @param texts the name of an array of strings, of which single ones can be read */
export function parseLazily(bytes: Uint8Array, columns: readonly string[], rows: readonly string[], texts: string): { value: object; text: ((index: number) => string) | null } {
  try {
    const { members, end } = membersOf(bytes, skipSpace(bytes, 0));
    if (skipSpace(bytes, end) < bytes.length) throw new NotPlain();
    const made: Record<string, () => unknown> = {};
    for (const name of columns) {
      const span = members.get(name);
      if (span && bytes[span[0]] === openBrace) made[name] = () => lazyObject(bytes, membersOf(bytes, span[0]).members);
    }
    for (const name of rows) {
      const span = members.get(name);
      if (span && bytes[span[0]] === open) made[name] = () => elementsOf(bytes, span).map((row) => (bytes[row[0]] === openBrace ? lazyObject(bytes, membersOf(bytes, row[0]).members) : parse(bytes, row)));
    }
    const value = lazyObject(bytes, members, made) as Record<string, unknown>;
    const list = members.get(texts);
    let places: Span[] | null = null;
    const text = (index: number): string => {
      places ??= elementsOf(bytes, list!);
      const place = places[index];
      return place && bytes[place[0]] === quote ? (parse(bytes, place) as string) : "";
    };
    return { value, text: list ? text : null };
  } catch (error) {
    if (!(error instanceof NotPlain)) throw error;
    return { value: JSON.parse(decoder.decode(bytes)) as object, text: null };
  }
}
