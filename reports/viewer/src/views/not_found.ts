import { h } from "../dom";
import type { View } from "../view";

export const notFound = (what: string): View => ({
  title: "Not found",
  element: h("section", {}, h("h1", {}, "Not found"), h("p", {}, `${what} in this report.`), h("p", {}, h("a", { href: "#/" }, "What the run found"))),
});
