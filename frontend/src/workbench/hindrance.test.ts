// @vitest-environment jsdom
import { afterEach, describe, expect, it } from "vitest";

import { markUnreadable } from "../ui/drafts";
import { answers } from "./answers";
import { hindrance } from "./hindrance";
import { pressureLoads } from "./loads";
import { start } from "./timeline";
import { bench, setLoads } from "./workbench";

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

  it("is no mark to correct once the bench holds another value than the one refused, but the wait for its check", () => {
    const work = { name: "Finger", design: { family: "slab", length_mm: 89 }, loads: pressureLoads(5000) };
    const origin = { kind: "preset", preset: "slab", title: "Slab" } as const;
    const sceneProblem = { field: "pressure", kind: "scene" as const, changes: [], message: "", value: "5000 kPa", mend: "" };
    bench.set(start({ work, baseline: work, origin }));
    answers.set({ ...FREE, sceneProblem, refusedWork: work });
    expect(hindrance()).toBe("Correct the marked parameter first.");
    setLoads("control", { control: "volume", volumeTo: 20 });
    expect(hindrance()).toBe("The change is being checked.");
    answers.set(FREE);
    expect(hindrance()).toBeNull();
    bench.set(null);
  });
});
