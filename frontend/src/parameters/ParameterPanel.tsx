import { useQuery } from "@tanstack/react-query";

import { messageOf } from "../api/client";
import { families, presets } from "../api/queries";
import { usePick, useStore } from "../api/store";
import type { Parameter, ProblemDetail } from "../api/types";
import { labelOf, placeInScene } from "../scene/places";
import { SceneGroup } from "../scene/SceneGroup";
import { Button } from "../ui/Button";
import { Busy, Notice } from "../ui/Notice";
import { Segmented } from "../ui/Segmented";
import { answers } from "../workbench/answers";
import { familyOf, type DesignDocument, type Work } from "../workbench/document";
import { bench, lastEdited, setParameters } from "../workbench/workbench";
import { densityOf, densityValues } from "./density";
import { ParameterRow } from "./ParameterRow";
import { Problem } from "./Problem";
import { isRelevant } from "./relevance";

/** Every parameter of the design on the bench, grouped as the family groups them. */
export function ParameterPanel() {
  const query = useQuery(families);
  const present = usePick(bench, (timeline) => timeline?.present ?? null);
  const { designProblem, sceneProblem } = useStore(answers);
  const edited = useStore(lastEdited);
  if (query.error) {
    return (
      <Notice tone="bad" action={<Button onClick={() => void query.refetch()}>Try again</Button>}>
        {messageOf(query.error)}
      </Notice>
    );
  }
  if (!query.data || !present) return <Busy label="Reading the parameters" />;
  const { work, baseline } = present;
  const family = query.data.find((each) => each.family === familyOf(work.design));
  if (!family) return <Notice tone="bad">This design belongs to a family that this version does not know.</Notice>;
  const parameters = family.parameters.filter((parameter) => isRelevant(parameter.name, work.design));
  const problem = designProblem ?? (sceneProblem && isEndGone(sceneProblem, work) ? null : sceneProblem);
  const named = problem && placeOf(problem, parameters, work);
  const inScene = problem !== null && named !== null && !parameters.some((each) => each.name === named.name);
  return (
    <div className="parameters" data-testid="parameters">
      {problem && !named && (
        <Notice tone="bad" testId="problem-general">
          <Problem id="problem-general" problem={problem} name="design" />
        </Notice>
      )}
      <SceneGroup
        work={work}
        baseline={baseline}
        problem={inScene ? problem : null}
        elsewhere={edited !== null && named && named.name !== edited ? { at: edited, place: named } : null}
      />
      {groupsOf(parameters).map(([group, members]) => (
        <section className="parameter-group" key={group} aria-label={group}>
          <h3>{group}</h3>
          {group === "Chambers" && work.design.family === "slab" && <DensityRow design={work.design} />}
          {members.map((parameter) => (
            <Row
              key={parameter.name}
              parameter={parameter}
              work={work}
              baseline={baseline}
              problem={problem}
              elsewhere={edited === parameter.border_name && named?.name !== parameter.name ? named : null}
            />
          ))}
        </section>
      ))}
    </div>
  );
}

interface RowOf {
  parameter: Parameter;
  work: Work;
  baseline: Work;
  problem: ProblemDetail | null;
  elsewhere: Place | null;
}

function Row({ parameter, work, baseline, problem, elsewhere }: RowOf) {
  const value = work.design[parameter.border_name] ?? parameter.default;
  const opened = baseline.design[parameter.border_name] ?? parameter.default;
  return (
    <ParameterRow
      parameter={parameter}
      value={value}
      opened={opened}
      problem={problem && names(problem, parameter) ? problem : null}
      elsewhere={elsewhere}
    />
  );
}

function DensityRow({ design }: { design: DesignDocument }) {
  const { data: list = [] } = useQuery(presets);
  const density = densityOf(list, design);
  return (
    <div className="parameter choice">
      <span className="parameter-name" title="Chamber density: sets number of chambers, channel and walls">
        <span className="parameter-label">Density</span>
      </span>
      <Segmented
        label="Chamber density"
        value={density}
        options={[
          { value: "low", label: "Low", title: "The source's low-density row" },
          { value: "high", label: "High", title: "The source's high-density row" },
          { value: "own", label: "Own", title: "Number of chambers and walls as set below", disabled: density !== "own" },
        ]}
        onChange={(next) => {
          if (next === "own") return;
          const values = densityValues(list, String(design.planform), next);
          if (values) setParameters("density", values);
        }}
        testId="choice-density"
      />
    </div>
  );
}

function groupsOf(parameters: readonly Parameter[]): [string, Parameter[]][] {
  const groups = new Map<string, Parameter[]>();
  for (const parameter of parameters) {
    groups.set(parameter.group, [...(groups.get(parameter.group) ?? []), parameter]);
  }
  return [...groups];
}

function names(problem: ProblemDetail, parameter: Parameter): boolean {
  const field = problem.field.split(".").at(-1);
  return field === parameter.name || field === parameter.border_name;
}

/** Of the end of the path by a pressure where now a volume ends it, or the other way round. */
function isEndGone(problem: ProblemDetail, { loads }: Work): boolean {
  const place = problem.kind === "design" ? null : placeInScene(problem.field, loads);
  return (place === "pressure" || place === "volume") && place !== loads.control;
}

type Place = Pick<Parameter, "name" | "label">;

/** The field that a refusal names; null where the page shows none. */
function placeOf(problem: ProblemDetail, parameters: readonly Parameter[], work: Work): Place | null {
  const inScene = problem.kind === "design" ? null : placeInScene(problem.field, work.loads);
  if (inScene) return { name: inScene, label: labelOf(inScene) };
  return parameters.find((parameter) => names(problem, parameter)) ?? null;
}
