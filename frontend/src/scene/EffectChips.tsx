import { usePick, useStore } from "../api/store";
import type { EffectDecision } from "../api/types";
import { Problem } from "../parameters/Problem";
import { Icon } from "../ui/Icon";
import { aboutPercent, formatPercent, formatQuantity, sentence } from "../ui/numbers";
import { Popover } from "../ui/Popover";
import { Segmented } from "../ui/Segmented";
import { useDrawn } from "../results/drawn";
import { sameQuestion } from "../workbench/document";
import { modelName } from "../workbench/model";
import { choosing, type Choice } from "../workbench/loads";
import { bench, setLoads } from "../workbench/workbench";
import { effectName, effectPlan, isThere } from "./effectPlan";
import type { SceneRows } from "./SceneGroup";

/** Every effect that the question could have: on or off, decided by the studio or by hand. */
export function EffectChips({ loads, problemAt }: SceneRows) {
  const { plan, asking } = useStore(effectPlan);
  const problem = problemAt("effects");
  const effects = plan?.effects ?? [];
  const there = effects.filter((effect) => isThere(effect) || effect.name in loads.forced);
  const absent = effects.filter((effect) => !there.includes(effect));
  const byHand = Object.keys(loads.forced).length;
  return (
    <div className={`effects-group${problem ? " invalid" : ""}`} data-testid="effects" data-asking={asking}>
      <div className="group-head">
        <h3 title="What a 3D solve holds, decided for the accuracy asked for. The instant models leave out what is switched off here.">Effects</h3>
        {byHand > 0 && (
          <button type="button" className="link add-load" data-testid="effects-auto" onClick={() => setLoads("effects", { forced: {} })}>
            <Icon name="reset" size={12} /> All automatic
          </button>
        )}
      </div>
      <div className={`chips${asking && plan ? " asking" : ""}`}>
        {plan === null && <span className="muted">Deciding</span>}
        {there.map((effect) => (
          <Chip key={effect.name} effect={effect} choice={loads.forced[effect.name] ?? "auto"} />
        ))}
      </div>
      {absent.length > 0 && (
        <p className="absent-effects" data-testid="effects-absent">
          {"Not here: "}
          {absent.map((effect, index) => (
            <span key={effect.name} title={sentence(effect.reason)}>
              {effectName(effect.name).toLowerCase()}
              {index < absent.length - 1 ? ", " : ""}
            </span>
          ))}
        </p>
      )}
      {problem && <Problem id="effects-problem" problem={problem} name="effects" />}
    </div>
  );
}

function stateOf(effect: EffectDecision, choice: Choice): "on" | "off" | "watched" {
  if (choice !== "auto") return choice;
  if (effect.on) return "on";
  return effect.watched ? "watched" : "off";
}

const WORDS = { on: "on", off: "off", watched: "off, watched" } as const;

function Chip({ effect, choice }: { effect: EffectDecision; choice: Choice }) {
  const state = stateOf(effect, choice);
  const name = effectName(effect.name);
  const by = choice === "auto" ? "automatic" : "by hand";
  return (
    <Popover
      label={name}
      button={(open, toggle) => (
        <button
          type="button"
          className={`chip ${state}${choice === "auto" ? "" : " forced"}`}
          aria-expanded={open}
          aria-label={`${name}: ${WORDS[state]}, ${by}. ${sentence(effect.reason)}`}
          title={`${WORDS[state]}, ${by}. ${sentence(effect.reason)}`}
          data-testid={`effect-${effect.name}`}
          data-state={state}
          data-choice={choice}
          onClick={toggle}
        >
          <span className="chip-dot" aria-hidden="true" />
          {name}
          {choice !== "auto" && <Icon name="edit" size={10} />}
        </button>
      )}
    >
      {() => <ChipCard effect={effect} choice={choice} />}
    </Popover>
  );
}

/** What each choice does, in the words of the effect itself. */
const OPTIONS: readonly { value: Choice; label: string; title: string }[] = [
  { value: "auto", label: "Auto", title: "Decided by estimates of the instant models, for the accuracy asked for" },
  { value: "on", label: "On", title: "Computed whatever it changes" },
  { value: "off", label: "Off", title: "Left out: for comparison" },
];

function ChipCard({ effect, choice }: { effect: EffectDecision; choice: Choice }) {
  const forced = usePick(bench, (timeline) => timeline?.present.work.loads.forced ?? null);
  const threshold = usePick(effectPlan, (now) => now.plan?.threshold_percent ?? null);
  const found = useFound(effect.name);
  const onlyAuto = effect.name === "volume_control";
  return (
    <div className="effect-card" data-testid={`effect-card-${effect.name}`}>
      <Segmented
        label={effectName(effect.name)}
        value={choice}
        options={onlyAuto ? OPTIONS.map((each) => ({ ...each, disabled: each.value !== "auto" })) : OPTIONS}
        onChange={(next) => setLoads(`effects.${effect.name}`, { forced: choosing(forced ?? {}, effect.name, next) })}
        testId={`choice-effect-${effect.name}`}
      />
      <p>{sentence(effect.reason)}</p>
      <dl>
        <div>
          <dt>Leaving it out changes the tip&rsquo;s way, estimated beforehand, by</dt>
          <dd title="By the linear rod, before anything is solved: what the studio decides by">{changeInWords(effect)}</dd>
        </div>
        {found !== null && (
          <div data-testid={`effect-found-${effect.name}`}>
            <dt>In the answer drawn ({modelName(found.rung)}) by</dt>
            <dd title="The same share, on the shapes of this answer with the effect and without">{aboutPercent(found.percent)}</dd>
          </div>
        )}
        <div>
          <dt>A 3D solve with it takes</dt>
          <dd>{costInWords(effect)}</dd>
        </div>
      </dl>
      {threshold !== null && choice === "auto" && (
        <p className="muted">At this accuracy, up to {formatPercent(threshold)} may be left out.</p>
      )}
      {choice !== "auto" && <p className="muted">Chosen by hand: the answer is marked.</p>}
    </div>
  );
}

/** What the instant answer drawn says of the same effect, on its own shapes; null where it does not, or answers another question. */
function useFound(name: string): { rung: string; percent: number } | null {
  const drawn = useDrawn();
  const present = usePick(bench, (timeline) => timeline?.present.work ?? null);
  if (drawn === null || present === null || !sameQuestion(drawn.answered, present)) return null;
  const percent = drawn.result.effects.find((each) => each.name === name && each.on)?.estimated_change_percent ?? null;
  return percent === null ? null : { rung: drawn.result.rung, percent };
}

function changeInWords(effect: EffectDecision): string {
  const change = effect.estimated_change_percent;
  if (change === null) return "not known";
  return aboutPercent(change);
}

function costInWords(effect: EffectDecision): string {
  const { cost_factor: factor } = effect;
  if (factor === null) return "as long as without";
  return factor < 1 ? `${formatQuantity(1 / factor, 2)} times less` : `${formatQuantity(factor, 2)} times as long`;
}
