import { describe, expect, it } from "vitest";

import { Lane } from "./lane";

/** A lane whose answers are given by hand. */
function manual() {
  const open: { question: number; answer: (text: string) => void; fail: () => void }[] = [];
  const answered: string[] = [];
  const failed: number[] = [];
  const lane = new Lane<number, string>(
    (question) =>
      new Promise((resolve, reject) => {
        open.push({ question, answer: resolve, fail: () => reject(new Error("no")) });
      }),
    (question, answer) => answered.push(`${question}:${answer}`),
    (question) => failed.push(question),
  );
  return { lane, open, answered, failed };
}

const settle = () => new Promise((resolve) => setTimeout(resolve, 0));

describe("lane", () => {
  it("has one question on its way and keeps only the latest waiting", async () => {
    const { lane, open, answered } = manual();
    for (const question of [1, 2, 3, 4]) lane.ask(question);
    expect(open.map((each) => each.question)).toEqual([1]);
    open[0]?.answer("a");
    await settle();
    expect(open.map((each) => each.question)).toEqual([1, 4]);
    open[1]?.answer("b");
    await settle();
    expect(answered).toEqual(["1:a", "4:b"]);
    expect(lane.pending).toBe(false);
  });

  it("goes on after a failure", async () => {
    const { lane, open, answered, failed } = manual();
    lane.ask(1);
    lane.ask(2);
    open[0]?.fail();
    await settle();
    open[1]?.answer("b");
    await settle();
    expect(failed).toEqual([1]);
    expect(answered).toEqual(["2:b"]);
  });
});
