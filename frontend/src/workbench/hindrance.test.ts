// @vitest-environment jsdom
import { afterEach, describe, expect, it } from "vitest";

import { markUnreadable } from "../ui/drafts";
import { answers } from "./answers";
import { hindrance } from "./hindrance";

const FREE = answers.get();

afterEach(() => answers.set(FREE));

describe("hindrance to saving and running", () => {
  it("is a text that cannot be read, by the name of its field, before a refused value", () => {
    expect(hindrance()).toBeNull();
    const sceneProblem = { field: "plate.gap", kind: "scene" as const, changes: [], message: "", value: "-5", mend: "" };
    answers.set({ ...FREE, sceneProblem });
    expect(hindrance()).toBe("Correct the marked parameter first.");
    const mended = markUnreadable({ label: "Gap", place: "plate.gap", words: "Write a number in mm.", said: false });
    expect(hindrance()).toBe("Gap cannot be read. Write a number in mm.");
    mended();
    answers.set(FREE);
    expect(hindrance()).toBeNull();
  });
});
