// @vitest-environment jsdom
import { describe, expect, it } from "vitest";

import { ApiProblem, messageOf, take, Unreachable } from "./client";

const reply = (status: number, error: unknown) =>
  Promise.resolve({ error, response: new Response(null, { status }) });

describe("take", () => {
  it("gives the data of a good answer", async () => {
    await expect(take(Promise.resolve({ data: 7, response: new Response("7") }))).resolves.toBe(7);
  });

  it("turns a refusal into field, value and mend", async () => {
    const detail = { message: "length is 5 mm.", field: "length", value: "5 mm", mend: "Raise length." };
    const error: unknown = await take(reply(422, { detail })).catch((each: unknown) => each);
    expect(error).toBeInstanceOf(ApiProblem);
    expect((error as ApiProblem).detail).toEqual(detail);
    expect(messageOf(error)).toBe("length is 5 mm. Raise length.");
  });

  it("has something to say when the body is not the studio's", async () => {
    const error: unknown = await take(reply(500, "<html>")).catch((each: unknown) => each);
    expect(messageOf(error)).toBe("The studio answered with status 500. Try again.");
  });

  it("knows a lost connection from a refusal", async () => {
    await expect(take(Promise.reject(new TypeError("Failed to fetch")))).rejects.toBeInstanceOf(Unreachable);
    await expect(take(reply(502, ""))).rejects.toBeInstanceOf(Unreachable);
  });
});
