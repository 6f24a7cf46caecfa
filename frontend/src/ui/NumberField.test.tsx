// @vitest-environment jsdom
import { act, cleanup, fireEvent, render, screen } from "@testing-library/react";
import { afterEach, describe, expect, it, vi } from "vitest";

import { dropDrafts, unreadable } from "./drafts";
import { NumberField } from "./NumberField";

afterEach(cleanup);

function field(onCommit: (value: number) => void, integer = false) {
  render(<NumberField value={4} step={0.1} unit="mm" label="Bottom layer" integer={integer} onCommit={onCommit} />);
  return screen.getByLabelText<HTMLInputElement>("Bottom layer in mm");
}

describe("number field", () => {
  it("takes a number by Enter and by leaving, once", () => {
    const commit = vi.fn();
    const input = field(commit);
    fireEvent.change(input, { target: { value: "5,5" } });
    expect(commit).not.toHaveBeenCalled();
    fireEvent.keyDown(input, { key: "Enter" });
    fireEvent.blur(input);
    expect(commit.mock.calls).toEqual([[5.5]]);
  });

  it("keeps what is no number and says so until it is mended; Escape gives the old number back", () => {
    const commit = vi.fn();
    const input = field(commit);
    fireEvent.change(input, { target: { value: "9" } });
    fireEvent.keyDown(input, { key: "Escape" });
    expect(input.value).toBe("4");
    fireEvent.change(input, { target: { value: "thick" } });
    expect(input.getAttribute("aria-invalid")).toBe("true");
    fireEvent.blur(input);
    expect(input.value).toBe("thick");
    expect(screen.getByRole("alert").textContent).toBe("Write a number in mm.");
    fireEvent.change(input, { target: { value: "" } });
    fireEvent.keyDown(input, { key: "Enter" });
    expect(screen.getByRole("alert")).toBeTruthy();
    fireEvent.keyDown(input, { key: "Escape" });
    expect(input.value).toBe("4");
    expect(input.getAttribute("aria-invalid")).toBe("false");
    expect(screen.queryByRole("alert")).toBeNull();
    expect(commit).not.toHaveBeenCalled();
  });

  it("steps by the arrow keys, with Shift ten steps", () => {
    const commit = vi.fn();
    const input = field(commit);
    fireEvent.keyDown(input, { key: "ArrowUp" });
    fireEvent.keyDown(input, { key: "ArrowDown", shiftKey: true });
    expect(commit.mock.calls).toEqual([[4.1], [3]]);
  });

  it("keeps counts whole", () => {
    const commit = vi.fn();
    const input = field(commit, true);
    fireEvent.change(input, { target: { value: "6.5" } });
    fireEvent.blur(input);
    expect(screen.getByRole("alert").textContent).toBe("Write a whole number.");
    expect(commit).not.toHaveBeenCalled();
    fireEvent.change(input, { target: { value: "7" } });
    fireEvent.keyDown(input, { key: "Enter" });
    expect(commit.mock.calls).toEqual([[7]]);
  });

  it("is known to hold no number from the first letter, and whether it says so", () => {
    const input = field(vi.fn());
    fireEvent.change(input, { target: { value: "thick" } });
    const words = "Write a number in mm.";
    expect(unreadable.get()).toEqual([{ label: "Bottom layer", place: undefined, words, said: false }]);
    fireEvent.keyDown(input, { key: "Enter" });
    expect(unreadable.get().map((each) => each.said)).toEqual([true]);
    fireEvent.change(input, { target: { value: "6" } });
    expect(unreadable.get()).toEqual([]);
    fireEvent.change(input, { target: { value: "thick" } });
    cleanup();
    expect(unreadable.get()).toEqual([]);
  });

  it("drops what was typed when something else is opened, the number being the same there", () => {
    const input = field(vi.fn());
    fireEvent.change(input, { target: { value: "thick" } });
    fireEvent.blur(input);
    act(dropDrafts);
    expect(input.value).toBe("4");
    expect(screen.queryByRole("alert")).toBeNull();
    expect(unreadable.get()).toEqual([]);
  });

  it("gives the old number back by undo while something is typed, and leaves undo to the bench else", () => {
    const commit = vi.fn();
    const input = field(commit);
    const above = vi.fn();
    window.addEventListener("keydown", above);
    expect(input.dataset.settled).toBe("true");
    fireEvent.change(input, { target: { value: "9" } });
    expect(input.dataset.settled).toBe("false");
    fireEvent.keyDown(input, { key: "z", ctrlKey: true });
    expect(input.value).toBe("4");
    expect(above).not.toHaveBeenCalled();
    fireEvent.keyDown(input, { key: "z", ctrlKey: true });
    expect(above).toHaveBeenCalledTimes(1);
    window.removeEventListener("keydown", above);
    fireEvent.blur(input);
    expect(commit).not.toHaveBeenCalled();
  });

  it("takes a quantity with a unit of its kind", () => {
    const commit = vi.fn();
    const input = field(commit);
    fireEvent.change(input, { target: { value: "1,2 cm" } });
    fireEvent.blur(input);
    expect(commit.mock.calls).toEqual([[12]]);
  });

  it("says why a number beyond its own bounds is not taken, also one stepped to, and hinders nothing where it stands aside", () => {
    const commit = vi.fn();
    render(<NumberField value={1} step={1} unit="s" label="Longest time" above={0} most={1e6} standsAside onCommit={commit} />);
    const input = screen.getByLabelText<HTMLInputElement>("Longest time in s");
    for (const text of ["0", "-3", "1e7", "300 h"]) {
      fireEvent.change(input, { target: { value: text } });
      fireEvent.keyDown(input, { key: "Enter" });
      expect(input.value).toBe(text);
      expect(screen.getByRole("alert").textContent).toBe("Must be above 0 and at most 1\u202f000\u202f000 s.");
      expect(unreadable.get()).toEqual([]);
      fireEvent.keyDown(input, { key: "Escape" });
    }
    fireEvent.keyDown(input, { key: "ArrowDown" });
    expect(input.value).toBe("0");
    expect(screen.getByRole("alert")).toBeTruthy();
    expect(commit).not.toHaveBeenCalled();
    fireEvent.change(input, { target: { value: "2 min" } });
    fireEvent.keyDown(input, { key: "Enter" });
    expect(commit.mock.calls).toEqual([[120]]);
  });
});
