import { useState } from "react";

interface InlineNameProps {
  value: string;
  label: string;
  placeholder?: string;
  onCommit: (value: string) => void;
  testId?: string;
}

/** Text that is edited where it stands: Enter keeps it, Escape gives the old one back. */
export function InlineName({ value, label, placeholder, onCommit, testId }: InlineNameProps) {
  const [draft, setDraft] = useState<string | null>(null);
  const shown = draft ?? value;
  const finish = () => {
    const next = draft?.trim();
    setDraft(null);
    if (next === undefined || next === value || (next === "" && !placeholder)) return;
    onCommit(next);
  };
  return (
    <span className="inline-name" data-text={shown || placeholder}>
      <input
        value={shown}
        placeholder={placeholder}
        aria-label={label}
        title={label}
        maxLength={200}
        size={1}
        spellCheck={false}
        data-testid={testId}
        onChange={(event) => setDraft(event.currentTarget.value)}
        onBlur={finish}
        onKeyDown={(event) => {
          if (event.key === "Enter") event.currentTarget.blur();
          if (event.key === "Escape" && draft !== null) {
            event.stopPropagation();
            setDraft(null);
          }
        }}
      />
    </span>
  );
}
