import { useQuery } from "@tanstack/react-query";

import { families } from "../api/queries";
import { usePick } from "../api/store";
import type { Parameter, ProblemDetail, ProposedChange } from "../api/types";
import { dropDrafts, unreadable } from "../ui/drafts";
import { familyOf, spell } from "../workbench/document";
import { bench, endGesture, setParameter } from "../workbench/workbench";
import { problemInWords } from "./problemInWords";

/** At the field that was edited, where the refusal names another one. */
export function SeeOther({ name, label }: { name: string; label: string }) {
  // A vector's first component, where it is one.
  const hooks = [name, `${name}-1`].map((each) => `[data-testid="field-${CSS.escape(each)}"]`);
  const go = () => document.querySelector<HTMLElement>(hooks.join(", "))?.focus();
  return (
    <p className="parameter-problem" data-testid="problem-elsewhere">
      See{" "}
      <button type="button" className="link" onClick={go}>
        {label}
      </button>
    </p>
  );
}

/** Changes that mend it, each a step that undo takes back. */
function Mends({ changes, parameters }: { changes: readonly ProposedChange[]; parameters: readonly Parameter[] }) {
  return changes.map(({ field, value }) => {
    const parameter = parameters.find((each) => each.border_name === field);
    if (!parameter) return null;
    const take = () => {
      endGesture();
      dropDrafts();
      setParameter(field, value);
    };
    return (
      <button key={field} type="button" className="button mend" data-testid={`mend-${parameter.name}`} onClick={take}>
        {`Set ${parameter.label.toLowerCase()} to ${spell(parameter, value)}`}
      </button>
    );
  });
}

/** What is wrong with a parameter and how to mend it; silent while a field of it says that its text
 * is no number, for then it is about a value that no longer stands there. */
export function Problem({ id, problem, name }: { id: string; problem: ProblemDetail; name: string }) {
  const { data: list = [] } = useQuery(families);
  const outdated = usePick(unreadable, (fields) => fields.some((field) => field.said && field.place === name));
  const family = usePick(bench, (timeline) => (timeline ? familyOf(timeline.present.work.design) : null));
  const parameters = list.find((each) => each.family === family)?.parameters ?? [];
  const { message, mend } = problemInWords(problem, parameters);
  if (outdated) return null;
  return (
    <p className="parameter-problem" id={id} role="alert" data-testid={`problem-${name}`}>
      {message}
      {mend && <strong> {mend}</strong>}
      <Mends changes={problem.changes} parameters={parameters} />
    </p>
  );
}
