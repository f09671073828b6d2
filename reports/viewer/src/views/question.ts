import type { MakeView } from "../view";
import { contactView } from "./contact";
import { notFound } from "./not_found";
import { worldView } from "./world";

/** A contact question or a world, by its id. */
export const questionView: MakeView = (run, at) => {
  const id = at.path.slice(1).join("/");
  const q = run.questionOf(id);
  const question = run.report.questions[q];
  if (!question) return notFound(`There is no question “${id}”`);
  if (question.contact) return contactView(run, q, question, at);
  if (question.world) return worldView(run, q, question, at);
  return notFound(`There are no data to draw of “${id}”`);
};
