import { QueryClient, useQuery } from "@tanstack/react-query";

import { api, ApiProblem, take } from "./client";
import type { Job, Preset } from "./types";

export const queryClient = new QueryClient({
  defaultOptions: {
    queries: {
      staleTime: 10_000,
      refetchOnWindowFocus: false,
      retry: (count, error) => !(error instanceof ApiProblem && error.status < 500) && count < 4,
    },
  },
});

export const keys = {
  jobs: ["jobs"] as const,
  designs: ["designs"] as const,
  design: (id: string) => ["designs", "one", id] as const,
  version: (id: string) => ["version", id] as const,
  result: (jobId: string) => ["result", jobId] as const,
};

const FOREVER = { staleTime: Infinity, gcTime: Infinity };

export const families = {
  queryKey: ["families"],
  queryFn: () => take(api.GET("/api/families")),
  ...FOREVER,
};

export const presets = {
  queryKey: ["presets"],
  queryFn: () => take(api.GET("/api/presets")),
  ...FOREVER,
};

/** Of a preset as it is published: its drawing never changes. */
export function presetDrawing(preset: Preset) {
  return {
    queryKey: ["preset-drawing", preset.name],
    queryFn: () => take(api.POST("/api/designs/check", { body: { design: preset.design } })),
    ...FOREVER,
  };
}

export const materials = {
  queryKey: ["materials"],
  queryFn: () => take(api.GET("/api/materials")),
  ...FOREVER,
};

export function version(id: string) {
  return {
    queryKey: keys.version(id),
    queryFn: () => take(api.GET("/api/versions/{version_id}", { params: { path: { version_id: id } } })),
  };
}

export function useJobs() {
  return useQuery({
    queryKey: keys.jobs,
    queryFn: () => take(api.GET("/api/jobs", { params: { query: { limit: 60 } } })),
  });
}

export function useDesigns(search: string, archived: boolean) {
  return useQuery({
    queryKey: [...keys.designs, search, archived],
    queryFn: () => take(api.GET("/api/designs", { params: { query: { search, archived } } })),
    placeholderData: (previous) => previous,
  });
}

export function useDesign(id: string | null) {
  return useQuery({
    queryKey: keys.design(id ?? ""),
    queryFn: () => take(api.GET("/api/designs/{design_id}", { params: { path: { design_id: id ?? "" } } })),
    enabled: id !== null,
  });
}

/** The result of a finished job never changes. */
export function useJobResult(jobId: string | null) {
  return useQuery({
    queryKey: keys.result(jobId ?? ""),
    queryFn: () => take(api.GET("/api/jobs/{job_id}/result", { params: { path: { job_id: jobId ?? "" } } })),
    enabled: jobId !== null,
    ...FOREVER,
  });
}

/** Seconds that a job under way was expected to take; asked once, for the answer is to be held against. */
export function useExpectedSeconds(job: Job | null) {
  const id = job?.id ?? "";
  const active = job?.state === "queued" || job?.state === "running";
  return useQuery({
    queryKey: ["expected", id],
    queryFn: () => take(api.GET("/api/jobs/{job_id}/expected", { params: { path: { job_id: id } } })),
    enabled: active,
    ...FOREVER,
  });
}

export function useComparison(left: string, right: string) {
  return useQuery({
    queryKey: ["compare", left, right],
    queryFn: () => take(api.GET("/api/compare", { params: { query: { left, right } } })),
  });
}

export function useHealth() {
  return useQuery({
    queryKey: ["health"],
    queryFn: () => take(api.GET("/api/health")),
    refetchInterval: 15_000,
    retry: false,
  });
}
