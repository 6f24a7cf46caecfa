import { useEffect, useRef, type ReactNode } from "react";

import { IconButton } from "./Button";

interface LayerProps {
  title: string;
  kind: "drawer" | "sheet" | "dialog";
  onClose: () => void;
  tools?: ReactNode;
  children: ReactNode;
  testId?: string;
}

/** Modal layer on the platform's dialog element: focus stays inside, Escape closes. */
export function Layer({ title, kind, onClose, tools, children, testId }: LayerProps) {
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    const element = dialog.current;
    if (element && !element.open) {
      element.showModal();
      // React's autoFocus comes too early for a dialog, which gives the focus to its first button.
      (element.querySelector<HTMLElement>("[data-autofocus]") ?? element).focus();
    }
    return () => element?.close();
  }, []);
  return (
    <dialog
      ref={dialog}
      className={`layer ${kind}`}
      tabIndex={-1}
      aria-label={title}
      data-testid={testId}
      onCancel={(event) => {
        event.preventDefault();
        onClose();
      }}
      onPointerDown={(event) => {
        if (event.target === dialog.current) onClose();
      }}
    >
      <div className="layer-body">
        <header className="layer-head">
          <h2>{title}</h2>
          <div className="spacer" />
          {tools}
          <IconButton icon="close" label="Close (Esc)" onClick={onClose} />
        </header>
        {children}
      </div>
    </dialog>
  );
}
