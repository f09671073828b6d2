import { bands } from "./bands";
import type { Run } from "./run";

/** The findings of an oracle that pass as set here and fail as the engine ships, in the order of the questions: of answers that pass.
 * @param question the only question that counts; -1 for all */
export function shippedOnlyOf(run: Run, oracle: number, question = -1): number[] {
  const { findings: f, names } = run.report;
  const found: number[] = [];
  for (let i = 0; i < f.oracle.length; ++i)
    if (f.oracle[i] === oracle && (question < 0 || f.question[i] === question) && names.shipped[f.shipped[i]] === "as shipped only" && bands[run.band[run.gravest(f.question[i], oracle)]] === "passed") found.push(i);
  return found;
}
