import { address, goTo } from "../app/address";
import { useDesign } from "../api/queries";
import { usePick } from "../api/store";
import { formatMoment } from "../ui/numbers";
import { Icon } from "../ui/Icon";
import { Popover } from "../ui/Popover";
import { bench } from "../workbench/workbench";

/** Compares the open version with another version of the same design; others through the history. */
export function CompareMenu() {
  const origin = usePick(bench, (timeline) => timeline?.present.origin ?? null);
  const open = origin?.kind === "version" ? origin : null;
  const { data: design } = useDesign(open?.designId ?? null);
  const others = design?.versions.filter((version) => version.id !== open?.versionId) ?? [];
  return (
    <Popover
      label="Compare with"
      align="end"
      button={(isOpen, toggle) => (
        <button
          type="button"
          className="button plain"
          aria-expanded={isOpen}
          disabled={!open}
          title={open ? "Compare this version with another" : "Save a version first; then it can be compared"}
          onClick={toggle}
          data-testid="open-compare"
        >
          <Icon name="compare" />
          <span>Compare</span>
        </button>
      )}
    >
      {(close) => (
        <div className="menu">
          {others.length === 0 && (
            <p className="menu-note">
              This design has one version only. Versions of other designs can be ticked in the history.
            </p>
          )}
          {others.map((version) => (
            <button
              key={version.id}
              type="button"
              className="menu-item"
              onClick={() => {
                close();
                if (open) goTo({ ...address.get(), compare: [version.id, open.versionId] });
              }}
            >
              <span className="menu-title">
                v{version.number} {version.label}
              </span>
              <span className="muted">
                {version.note || version.author}, {formatMoment(version.created_at)}
              </span>
            </button>
          ))}
        </div>
      )}
    </Popover>
  );
}
