/** Requests about machines: queues, stations, operations, tools and statistics; and the state of the server. */

import type { components, paths } from "./openapi.gen";
import { operatorName } from "./operator";
import { api, byName, dataOf, nowOrNever, revalidated, uncached } from "./restApi";
import { fetchOnce } from "./transport";

type Schemas = components["schemas"];
type StationPaths = paths["/api/v1/machines/{name}/station"];
export type Machine = Schemas["MachineOut"];
/** State of a machine for the person at it. */
export type Station = StationPaths["get"]["responses"]["200"]["content"]["application/json"];
export type Operation = Schemas["OperationOut"];
/** What a machine does above the board for a person, while a job waits. */
export type Activity = Schemas["ActivityOut"];
/** What a person at a machine requests between two jobs. */
export type OperationRequest = Omit<Schemas["OperationIn"], "hands_clear">;
export type Queue = Schemas["QueueOut"];
export type QueueEntry = Schemas["QueueEntry"];
export type ServiceStatus = Schemas["ServiceOut"];
export type Statistics = Schemas["StatisticsOut"];
export type ToolUse = Schemas["ToolUseOut"];

/** Time (s) after which a machine's state counts as not answered. */
const SILENCE = 2;

export const machineService = {
  queue: async (machine: string, signal?: AbortSignal): Promise<Queue & { tag: string | null }> => {
    const { data, response } = await api.GET("/api/v1/machines/{name}/queue", {
      params: byName(machine),
      ...uncached(signal),
    });
    return { ...(data as Queue), tag: response.headers.get("ETag") };
  },
  statistics: (
    { machine, step, since }: { machine: string; step: "day" | "week" | "month"; since: number },
    signal?: AbortSignal,
  ): Promise<Statistics[]> => {
    const zone = Intl.DateTimeFormat().resolvedOptions().timeZone;
    const query = { machine, step, since: new Date(since * 1000).toISOString(), zone };
    return dataOf(api.GET("/api/v1/statistics", { params: { query }, ...uncached(signal) }));
  },
  tools: (machine: string, signal?: AbortSignal): Promise<ToolUse[]> =>
    dataOf(
      api.GET("/api/v1/machines/{name}/tools", { params: byName(machine), ...uncached(signal) }),
    ),
  recordToolChange: (machine: string, station: number): Promise<ToolUse[]> =>
    dataOf(
      api.POST("/api/v1/machines/{name}/tools/{station}/changed", {
        params: { path: { name: machine, station } },
        body: { by: operatorName() },
      }),
    ),
  setToolLife: (machine: string, station: number, life: number): Promise<ToolUse[]> =>
    dataOf(
      api.PUT("/api/v1/machines/{name}/tools/{station}/life", {
        params: { path: { name: machine, station } },
        body: { life, by: operatorName() },
      }),
    ),
  status: (signal?: AbortSignal): Promise<ServiceStatus> =>
    dataOf(api.GET("/api/v1/service", uncached(signal))),
  machines: (signal?: AbortSignal): Promise<Machine[]> =>
    dataOf(api.GET("/api/v1/machines", revalidated(signal))),
  station: (name: string, signal: AbortSignal): Promise<Station> =>
    dataOf(
      api.GET("/api/v1/machines/{name}/station", {
        params: byName(name),
        cache: "no-store",
        fetch: fetchOnce,
        signal: AbortSignal.any([signal, AbortSignal.timeout(SILENCE * 1000)]),
      }),
    ),
  operate: (name: string, request: OperationRequest): Promise<Operation> =>
    dataOf(
      api.POST("/api/v1/machines/{name}/operations", {
        params: byName(name),
        body: { hands_clear: false, ...request },
        ...nowOrNever(),
      }),
    ),
  stateHandsClear: (name: string): Promise<Schemas["HandsClearOut"]> =>
    dataOf(
      api.POST("/api/v1/machines/{name}/hands-clear", { params: byName(name), ...nowOrNever() }),
    ),
  withdrawHandsClear: async (name: string): Promise<void> => {
    await api.DELETE("/api/v1/machines/{name}/hands-clear", {
      params: byName(name),
      ...nowOrNever(),
    });
  },
  renewJog: (name: string, id: string): Promise<Operation> =>
    dataOf(
      api.POST("/api/v1/machines/{name}/operations/{id}/renew", {
        params: { path: { name, id } },
        ...nowOrNever(),
      }),
    ),
  operation: (name: string, id: string): Promise<Operation> =>
    dataOf(
      api.GET("/api/v1/machines/{name}/operations/{id}", {
        params: { path: { name, id } },
        cache: "no-store",
        ...nowOrNever(),
      }),
    ),
};
