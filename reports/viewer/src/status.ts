import type { Cluster } from "./data";
import type { Run } from "./run";

/** The place of a fault in the ledger, in words; no words without a ledger. */
export interface Status { name: string; meaning: string; isFailure: boolean }

const ledgers = new WeakMap<Run, boolean>();

/** Whether the ledger is about the questions of the page. The built-in one is about the catalogue, so a sweep and a folder of one's own have none,
 * unless an entry knows a fault of theirs. */
export function hasLedger(run: Run): boolean {
  const known = ledgers.get(run);
  if (known !== undefined) return known;
  const { ledger, questions, findings } = run.report;
  const isKnown = (entry: number): boolean => entry >= 0;
  const has = ledger.length > 0 && (questions.some((q) => !q.own) || findings.ledger.some(isKnown) || (findings.outgrown ?? []).some(isKnown));
  ledgers.set(run, has);
  return has;
}

export function statusOf(run: Run, cluster: Cluster): Status {
  if (run.report.sweep) {
    return cluster.is_new ? { name: "new", meaning: "the ledger of known faults has no entry of this oracle, verdict, measure and cause", isFailure: true }
      : { name: "known kind", meaning: "the ledger of known faults has entries of this oracle, verdict, measure and cause, about scenarios of the catalogue", isFailure: false };
  }
  if (!hasLedger(run)) return { name: "", meaning: "", isFailure: true };
  if (cluster.has_outgrown) return { name: "known, now larger than its bound", meaning: "the ledger of known faults has it, and allows less than was measured", isFailure: true };
  return cluster.is_new ? { name: "new", meaning: "not in the ledger of known faults", isFailure: true }
    : { name: "in our ledger", meaning: "in the ledger of known and accepted faults, and no larger than there", isFailure: false };
}
