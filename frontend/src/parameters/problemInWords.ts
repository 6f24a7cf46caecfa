import type { Parameter, ProblemDetail } from "../api/types";
import { capital, isSaid } from "../ui/numbers";

/** The message with parameters called as the page calls them ("side_wall" is "Side wall"), and the
 * mend where the message does not hold it already. */
export function problemInWords(
  problem: ProblemDetail,
  parameters: readonly Pick<Parameter, "name" | "label">[],
): { message: string; mend: string } {
  const labels = new Map(parameters.map((parameter) => [parameter.name, parameter.label]));
  const spell = (text: string) =>
    capital(
      text.replace(/\b[a-z][a-z0-9]*(?:_[a-z0-9]+)+\b/g, (name) => {
        const label = labels.get(name);
        return label === undefined ? name : label.charAt(0).toLowerCase() + label.slice(1);
      }),
    );
  const message = spell(problem.message);
  const mend = spell(problem.mend);
  return { message, mend: isSaid(mend, message) ? "" : mend };
}
