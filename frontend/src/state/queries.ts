/** What the service knows, asked for once, kept, and refreshed by its events. */

import { QueryClient, queryOptions, useQuery } from "@tanstack/react-query";
import { type Job, service } from "../api/client";
import { listen } from "../api/events";
import { timeline } from "../geometry/timeline";
import { hasProgram } from "./jobs";
import { usePage } from "./store";

export const queries = new QueryClient({
  defaultOptions: { queries: { retry: 1, staleTime: 30_000, refetchOnWindowFocus: false } },
});

const ask = {
  drawings: () =>
    queryOptions({ queryKey: ["drawings"], queryFn: ({ signal }) => service.drawings(signal) }),
  drawing: (id: string) =>
    queryOptions({
      queryKey: ["drawing", id],
      queryFn: ({ signal }) => service.drawing(id, signal),
    }),
  edges: (id: string) =>
    queryOptions({
      queryKey: ["edges", id],
      queryFn: ({ signal }) => service.edges(id, signal),
      structuralSharing: false,
    }),
  ledger: (id: string) =>
    queryOptions({ queryKey: ["ledger", id], queryFn: ({ signal }) => service.ledger(id, signal) }),
  jobs: () => queryOptions({ queryKey: ["jobs"], queryFn: ({ signal }) => service.jobs(signal) }),
  job: (id: string) =>
    queryOptions({ queryKey: ["job", id], queryFn: ({ signal }) => service.job(id, signal) }),
  verdict: (id: string) =>
    queryOptions({
      queryKey: ["verdict", id],
      queryFn: ({ signal }) => service.verdict(id, signal),
      staleTime: Number.POSITIVE_INFINITY,
    }),
  toolpath: (id: string) =>
    queryOptions({
      queryKey: ["toolpath", id],
      queryFn: ({ signal }) => service.toolpath(id, signal),
      staleTime: Number.POSITIVE_INFINITY,
      structuralSharing: false,
    }),
  machines: () =>
    queryOptions({
      queryKey: ["machines"],
      queryFn: ({ signal }) => service.machines(signal),
      refetchInterval: 4000,
    }),
  boards: () =>
    queryOptions({ queryKey: ["boards"], queryFn: ({ signal }) => service.boards(signal) }),
  profiles: () =>
    queryOptions({ queryKey: ["profiles"], queryFn: ({ signal }) => service.profiles(signal) }),
};

export const keys = ask;

export const useDrawings = () => useQuery(ask.drawings());
export const useMachines = () => useQuery(ask.machines());
export const useBoards = () => useQuery(ask.boards());
export const useProfiles = () => useQuery(ask.profiles());
export const useJobs = () => useQuery(ask.jobs());

export function useDrawing() {
  const id = usePage((page) => page.drawing);
  return useQuery({ ...ask.drawing(id ?? ""), enabled: id !== null });
}

export function useEdges() {
  const id = usePage((page) => page.drawing);
  return useQuery({ ...ask.edges(id ?? ""), enabled: id !== null });
}

/** The job that is looked at. */
export function useJob() {
  const id = usePage((page) => page.job);
  return useQuery({ ...ask.job(id ?? ""), enabled: id !== null });
}

export function useVerdict() {
  const { data: job } = useJob();
  return useQuery({
    ...ask.verdict(job?.id ?? ""),
    enabled: job !== undefined && job.verdict !== null,
  });
}

export function useToolpath() {
  const { data: job } = useJob();
  return useQuery({
    ...ask.toolpath(job?.id ?? ""),
    enabled: job !== undefined && hasProgram(job),
  });
}

/** The toolpath of the job laid out in time. */
export function useTimeline() {
  const { data: job } = useJob();
  return useQuery({
    ...ask.toolpath(job?.id ?? ""),
    enabled: job !== undefined && hasProgram(job),
    select: timeline,
  });
}

/** Take a job as the service just told it, wherever it is shown. */
export function heardJob(job: Job): void {
  const known = queries.getQueryData(ask.job(job.id).queryKey);
  if (known !== undefined && known.updated > job.updated) return;
  queries.setQueryData(ask.job(job.id).queryKey, job);
  // A job that begins or ends makes a table busy or free.
  if (known?.state !== job.state) {
    void queries.invalidateQueries({ queryKey: ask.machines().queryKey });
  }
  queries.setQueryData(ask.jobs().queryKey, (jobs) => {
    if (jobs === undefined) return jobs;
    const at = jobs.findIndex(({ id }) => id === job.id);
    return at < 0 ? [job, ...jobs] : jobs.with(at, job);
  });
}

const isJob = (data: unknown): data is Job =>
  typeof data === "object" && data !== null && "id" in data && "state" in data && "stage" in data;

/** Follow the service's events until the returned function is called. */
export function follow(): () => void {
  let broken = false;
  return listen("/api/events", ["job", "drawing", "deleted"], {
    onEvent: (name, data) => {
      if (name === "job" && isJob(data)) heardJob(data);
      // Another page, or an order by REST, brought a drawing or took it away.
      else void queries.invalidateQueries({ queryKey: ask.drawings().queryKey });
    },
    onLine: (line) => {
      usePage.getState().set({ line });
      if (line === "broken") broken = true;
      else if (line === "open" && broken) {
        broken = false;
        // What happened while nobody listened.
        void queries.invalidateQueries();
      }
    },
  });
}
