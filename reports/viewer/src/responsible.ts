import type { Cluster, Responsible } from "./data";
import { h } from "./dom";
import type { Run } from "./run";

export const responsibles: readonly Responsible[] = ["engine", "adapter", "model"];

export const responsibleTexts: Record<Responsible, { name: string; meaning: string }> = {
  engine: { name: "engine's fault", meaning: "The engine answers wrongly." },
  adapter: { name: "our setting", meaning: "A setting that the adapter of this repository chooses shows it. A user with other settings may not see it." },
  model: { name: "documented model", meaning: "The engine documents a simplification, or solves another law on purpose. Its answer differs from the truth, but not from its manual." },
};

export const responsibleOf = (cluster: Cluster): Responsible => cluster.responsible ?? "engine";

/** The party that is responsible for one finding: the one that its entry of the ledger names, or what its cause shows. */
export function responsibleFor({ report: { clusters, findings: f, ledger, names } }: Run, finding: number): Responsible {
  const entry = ledger[f.ledger[finding] >= 0 ? f.ledger[finding] : f.outgrown?.[finding] ?? -1];
  const who = entry?.responsible ?? clusters[f.cluster[finding]]?.responsible ?? "engine";
  if (who !== "engine") return who;
  const cause = names.cause[f.cause[finding]];
  return cause === "model" ? "model" : cause === "setting" ? "adapter" : who;
}

/** The cause of a finding, as the page tells it: one verdict. Where the ledger names who is responsible, that is the verdict. A cause that follows from
 * experiments alone, such as "a defect", would be a second one beside it. The measured numbers stay. */
export function causeOf(run: Run, finding: number): { verdict: string; meaning: string; measured: string } {
  const { findings: f, names } = run.report;
  const who = responsibleFor(run, finding);
  const measured = run.text(f.cause_because[finding]);
  const found = names.cause[f.cause[finding]] ?? "";
  return who === "engine" ? { verdict: found, meaning: "", measured } : { verdict: responsibleTexts[who].name, meaning: responsibleTexts[who].meaning, measured };
}

/** A mark of a finding that is not simply the engine's; null for any other. */
export function responsibleMarkOf(run: Run, finding: number): HTMLElement | null {
  return markOf(responsibleFor(run, finding));
}

const markOf = (who: Responsible): HTMLElement | null => (who === "engine" ? null : h("span", { class: "responsible", title: responsibleTexts[who].meaning }, responsibleTexts[who].name));

/** A mark of a fault that is not simply the engine's; null for any other. */
export function responsibleMark(cluster: Cluster): HTMLElement | null {
  return markOf(responsibleOf(cluster));
}
