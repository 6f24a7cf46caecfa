import { useQuery } from "@tanstack/react-query";

import { families } from "../api/queries";
import type { ProblemDetail } from "../api/types";
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

/** What is wrong with a parameter and how to mend it. */
export function Problem({ id, problem, name }: { id: string; problem: ProblemDetail; name: string }) {
  const { data: list = [] } = useQuery(families);
  const { message, mend } = problemInWords(
    problem,
    list.flatMap((family) => family.parameters),
  );
  return (
    <p className="parameter-problem" id={id} role="alert" data-testid={`problem-${name}`}>
      {message}
      {mend && <strong> {mend}</strong>}
    </p>
  );
}
