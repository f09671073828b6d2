/** A picture of a view for a slide: with its title, its labels, its scale bar, its time and its legend, which lie beside or over it on the page. */
export interface Caption {
  title: string;
  /** One line each: the fault, the engine, the size of the error. */
  lines: string[];
  /** The movement or the moment that is shown now. */
  state: string;
  /** Marks of the legend, as pictures and words. */
  legend: { mark: SVGElement | null; text: string }[];
}

const text = (element: Element | null): string => (element?.textContent ?? "").replace(/\s+/g, " ").trim();

/** Reads the caption of a view from the page around it. */
export function captionOf(stage: Element): Caption {
  const page = stage.closest("section") ?? document.body;
  const column = stage.parentElement ?? page;
  const told = [...page.querySelectorAll(".told:not([hidden]) > p")].map(text);
  const clock = text(column.querySelector(".clock"));
  return {
    title: text(page.querySelector("h1")), lines: told, state: [clock, text(column.querySelector(".reading"))].filter((part) => part !== "").join(" · "),
    legend: [...column.querySelectorAll(".stage-legend li, .marks li")].map((li) => ({ mark: li.querySelector("svg"), text: text(li) })),
  };
}

/** Properties of marks that come from the style sheet. */
const inked = ["fill", "stroke", "stroke-width", "opacity"] as const;

async function pictureOfMark(mark: SVGElement): Promise<HTMLImageElement | null> {
  const copy = mark.cloneNode(true) as SVGElement;
  const [own, cloned] = [mark.querySelectorAll("*"), copy.querySelectorAll("*")];
  own.forEach((part, i) => { const style = getComputedStyle(part); for (const key of inked) (cloned[i] as SVGElement).setAttribute(key, style.getPropertyValue(key)); });
  const [, , width, height] = (mark.getAttribute("viewBox") ?? "0 0 16 12").split(" ").map(Number);
  copy.setAttribute("width", String(width * 4));
  copy.setAttribute("height", String(height * 4));
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  const image = new Image();
  image.src = `data:image/svg+xml,${encodeURIComponent(new XMLSerializer().serializeToString(copy))}`;
  try {
    await image.decode();
    return image;
  } catch {
    return null;
  }
}

/** Lines of a text that fit a width. */
function wrapped(context: CanvasRenderingContext2D, words: string, width: number): string[] {
  const lines = [""];
  for (const word of words.split(" ")) {
    const longer = lines[lines.length - 1] === "" ? word : `${lines[lines.length - 1]} ${word}`;
    if (context.measureText(longer).width <= width || lines[lines.length - 1] === "") lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines.filter((line) => line !== "");
}

/** Width of a saved picture [px]. */
export const pictureWidth = 1920;

/** Composes a picture of a view.
 * @param view the scene, drawn `pictureWidth` wide
 * @param stage the element of the view, of which labels and scale bar are copied */
export async function composePicture(view: HTMLCanvasElement, stage: HTMLElement, caption: Caption): Promise<Blob | null> {
  const style = getComputedStyle(document.documentElement);
  const [ground, ink, quiet, stageColour] = ["--ground", "--ink", "--quiet", "--stage"].map((name) => style.getPropertyValue(name).trim());
  const family = style.fontFamily;
  const [edge, unit] = [36, pictureWidth / stage.clientWidth];
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d");
  if (!context) return null;
  const wide = pictureWidth - 2 * edge;
  const marks = await Promise.all(caption.legend.map(({ mark }) => (mark ? pictureOfMark(mark) : null)));
  const fonts = { title: `650 42px ${family}`, line: `28px ${family}`, state: `600 28px ${family}`, legend: `24px ${family}` };
  const lines = (words: string, font: string): string[] => { context.font = font; return wrapped(context, words, wide); };
  const head = [...lines(caption.title, fonts.title).map((line) => [line, fonts.title, 54] as const), ...caption.lines.flatMap((words) => lines(words, fonts.line).map((line) => [line, fonts.line, 38] as const))];
  const foot = lines(caption.state, fonts.state);
  // The legend in rows.
  context.font = fonts.legend;
  let [x, row] = [0, 0];
  const places = caption.legend.map(({ text: words }) => {
    const size = 52 + context.measureText(words).width + 28;
    if (x > 0 && x + size > wide) { x = 0; ++row; }
    const place = { x, row };
    x += size;
    return place;
  });
  const headHeight = edge + head.reduce((sum, [, , height]) => sum + height, 0) + 14;
  const viewHeight = Math.round(stage.clientHeight * unit);
  const footTop = headHeight + viewHeight + 14;
  canvas.width = pictureWidth;
  canvas.height = Math.ceil(footTop + foot.length * 38 + (places.length > 0 ? (row + 1) * 40 + 10 : 0) + edge);
  context.fillStyle = ground;
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.textBaseline = "top";
  let y = edge;
  for (const [line, font, height] of head) {
    context.font = font;
    context.fillStyle = ink;
    context.fillText(line, edge, y);
    y += height;
  }
  context.fillStyle = stageColour;
  context.fillRect(0, headHeight, pictureWidth, viewHeight);
  context.drawImage(view, 0, headHeight, pictureWidth, viewHeight);
  const frame = stage.getBoundingClientRect();
  const placeOf = (element: Element): DOMRect => { const box = element.getBoundingClientRect(); return new DOMRect((box.x - frame.x) * unit, headHeight + (box.y - frame.y) * unit, box.width * unit, box.height * unit); };
  context.lineJoin = "round";
  for (const label of stage.querySelectorAll<HTMLElement>(".label:not([hidden])")) {
    const own = getComputedStyle(label);
    const box = placeOf(label);
    context.font = `${own.fontWeight} ${parseFloat(own.fontSize) * unit}px ${family}`;
    context.strokeStyle = stageColour;
    context.lineWidth = 6;
    context.strokeText(label.textContent ?? "", box.x, box.y);
    context.fillStyle = ink;
    context.fillText(label.textContent ?? "", box.x, box.y);
  }
  const bar = stage.querySelector(".scale-bar");
  if (bar) {
    const box = placeOf(bar);
    context.strokeStyle = context.fillStyle = ink;
    context.lineWidth = 3;
    context.beginPath();
    context.moveTo(box.x, box.y);
    context.lineTo(box.x, box.bottom);
    context.lineTo(box.right, box.bottom);
    context.lineTo(box.right, box.y);
    context.stroke();
    context.font = fonts.legend;
    context.fillText(text(bar), box.x, box.y - 30);
  }
  const inset = document.querySelector<HTMLCanvasElement>(".close-up canvas");
  if (inset && inset.offsetWidth > 0 && placeOf(inset).y >= headHeight) {
    const box = placeOf(inset);
    context.fillStyle = ground;
    context.fillRect(box.x, box.y, box.width, box.height);
    context.drawImage(inset, box.x, box.y, box.width, box.height);
    context.strokeStyle = quiet;
    context.lineWidth = 2;
    context.strokeRect(box.x, box.y, box.width, box.height);
  }
  y = footTop;
  context.fillStyle = ink;
  context.font = fonts.state;
  for (const line of foot) { context.fillText(line, edge, y); y += 38; }
  y += 10;
  context.font = fonts.legend;
  context.fillStyle = quiet;
  places.forEach((place, i) => {
    const mark = marks[i];
    if (mark) context.drawImage(mark, edge + place.x, y + place.row * 40 + 2, mark.width / 2 + 8, mark.height / 2 + 6);
    context.fillText(caption.legend[i].text, edge + place.x + 48, y + place.row * 40);
  });
  return new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
}
