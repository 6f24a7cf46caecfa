import createClient from "openapi-fetch";

import { isSaid } from "../ui/numbers";
import type { paths } from "./schema";
import type { ProblemDetail } from "./types";

/** A refusal of what is tried on the way comes as an answer: browsers log each status of 400 and more as an error. */
const AS_ANSWER = "refusal=answer";

export const api = createClient<paths>({ baseUrl: window.location.origin, headers: { Prefer: AS_ANSWER } });

/** An answer that says what is wrong, which value, and how to mend it. */
export class ApiProblem extends Error {
  override readonly name = "ApiProblem";
  constructor(
    readonly status: number,
    readonly detail: ProblemDetail,
  ) {
    super(detail.message);
  }
}

/** No answer at all: the studio cannot be reached. */
export class Unreachable extends Error {
  override readonly name = "Unreachable";
  constructor() {
    super("The studio cannot be reached.");
  }
}

interface Reply<T> {
  data?: T;
  error?: unknown;
  response: Response;
}

function isDetail(value: unknown): value is ProblemDetail {
  return typeof value === "object" && value !== null && "message" in value && "mend" in value;
}

function problemOf(status: number, body: unknown): ApiProblem {
  if (typeof body === "object" && body !== null && "detail" in body && isDetail(body.detail)) {
    return new ApiProblem(status, body.detail);
  }
  const message = `The studio answered with status ${status}.`;
  return new ApiProblem(status, { message, field: "", value: "", mend: "Try again.", kind: "", changes: [] });
}

/** The data of a reply, or the error thrown as ApiProblem or Unreachable. */
export async function take<T>(pending: Promise<Reply<T>>): Promise<T> {
  let reply: Reply<T>;
  try {
    reply = await pending;
  } catch (error) {
    if (error instanceof TypeError) throw new Unreachable();
    throw error;
  }
  // A development server or proxy in front answers 502 or 504 when the studio is down.
  if (reply.response.status === 502 || reply.response.status === 504) throw new Unreachable();
  if (reply.response.headers.get("Preference-Applied") === AS_ANSWER) throw problemOf(422, reply.data);
  if (!reply.response.ok) throw problemOf(reply.response.status, reply.error);
  return reply.data as T;
}

export function messageOf(error: unknown): string {
  if (error instanceof ApiProblem) {
    const { message, mend } = error.detail;
    return mend && !isSaid(mend, message) ? `${message} ${mend}` : message;
  }
  return error instanceof Error ? error.message : String(error);
}
