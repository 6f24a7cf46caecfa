import { useEffect, useState } from "react";

import type { Job } from "../api/types";

/** Seconds a job has run: the server's number, counted on by the clock while it runs. */
export function useElapsed(job: Job | null): number | null {
  const running = job?.state === "running";
  const [now, setNow] = useState(() => Date.now());
  useEffect(() => {
    if (!running) return;
    const timer = window.setInterval(() => setNow(Date.now()), 500);
    return () => window.clearInterval(timer);
  }, [running]);
  if (job === null) return null;
  if (!running || job.started_at === null) return job.elapsed_s;
  return Math.max(job.elapsed_s ?? 0, (now - Date.parse(job.started_at)) / 1000);
}
