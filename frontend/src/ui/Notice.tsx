import type { ReactNode } from "react";

import { Icon, type IconName } from "./Icon";

type Tone = "info" | "warn" | "bad" | "good";

const ICONS: Record<Tone, IconName> = { info: "info", warn: "warning", bad: "warning", good: "check" };

export function Notice(props: { tone: Tone; children: ReactNode; action?: ReactNode; testId?: string }) {
  return (
    <div className={`notice ${props.tone}`} role={props.tone === "bad" ? "alert" : "status"} data-testid={props.testId}>
      <Icon name={ICONS[props.tone]} />
      <div className="notice-text">{props.children}</div>
      {props.action}
    </div>
  );
}

export function Empty({ title, children }: { title: string; children?: ReactNode }) {
  return (
    <div className="empty">
      <p className="empty-title">{title}</p>
      {children && <div className="empty-text">{children}</div>}
    </div>
  );
}

export function Busy({ label }: { label: string }) {
  return (
    <div className="busy" role="status">
      <span className="spinner" aria-hidden="true" />
      <span>{label}</span>
    </div>
  );
}
