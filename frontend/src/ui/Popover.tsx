import { useEffect, useLayoutEffect, useRef, useState, type ReactNode } from "react";

interface PopoverProps {
  button: (open: boolean, toggle: () => void) => ReactNode;
  children: (close: () => void) => ReactNode;
  align?: "start" | "end";
  label: string;
}

/** Room left beside a panel. */
const EDGE = 8;

/** What cuts off an element that reaches beyond it: the nearest one around it that scrolls, or the window. */
function frameOf(element: HTMLElement): { left: number; right: number } {
  for (let around = element.parentElement; around !== null; around = around.parentElement) {
    if (getComputedStyle(around).overflowX !== "visible") return around.getBoundingClientRect();
  }
  return { left: 0, right: window.innerWidth };
}

/** Panel under its button, moved sideways where it would be cut off; closes by Escape, by a click outside and when focus leaves it. */
export function Popover({ button, children, align = "start", label }: PopoverProps) {
  const [open, setOpen] = useState(false);
  const root = useRef<HTMLDivElement>(null);
  const panel = useRef<HTMLDivElement>(null);

  useLayoutEffect(() => {
    if (panel.current === null) return;
    const [frame, box] = [frameOf(panel.current), panel.current.getBoundingClientRect()];
    const fromRight = Math.min(0, frame.right - EDGE - box.right);
    const shift = Math.max(fromRight, frame.left + EDGE - box.left);
    panel.current.style.translate = shift === 0 ? "" : `${shift}px 0`;
  }, [open]);

  useEffect(() => {
    if (!open) return;
    const outside = (event: Event) => {
      if (event.target instanceof Node && !root.current?.contains(event.target)) setOpen(false);
    };
    const escape = (event: KeyboardEvent) => {
      if (event.key !== "Escape") return;
      setOpen(false);
      root.current?.querySelector("button")?.focus();
    };
    document.addEventListener("pointerdown", outside);
    document.addEventListener("focusin", outside);
    document.addEventListener("keydown", escape);
    return () => {
      document.removeEventListener("pointerdown", outside);
      document.removeEventListener("focusin", outside);
      document.removeEventListener("keydown", escape);
    };
  }, [open]);

  return (
    <div className="popover-anchor" ref={root}>
      {button(open, () => setOpen(!open))}
      {open && (
        <div className={`popover ${align}`} role="dialog" aria-label={label} ref={panel}>
          {children(() => setOpen(false))}
        </div>
      )}
    </div>
  );
}
