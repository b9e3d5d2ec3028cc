import { beforeEach, describe, expect, test, vi } from "vitest";

/** A storage as browsers have it. */
function storage(values: Record<string, string> = {}) {
  const kept = new Map(Object.entries(values));
  return {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => void kept.set(key, value),
  };
}

/** The modules as a page loads them. */
async function loaded() {
  vi.resetModules();
  const { useOperator } = await import("./operator");
  const { operatorName } = await import("../../api/operator");
  return { state: useOperator, operatorName };
}

describe("the operator of a device", () => {
  beforeEach(() => vi.unstubAllGlobals());

  test("is asked for once, and is known after the page is loaded again", async () => {
    vi.stubGlobal("localStorage", storage());
    const first = await loaded();
    expect(first.state.getState().name).toBeNull();
    expect(first.operatorName()).toBe("");
    first.state.getState().keep("  Ada   Lovelace ");
    expect(first.operatorName()).toBe("Ada Lovelace");
    const again = await loaded();
    expect(again.state.getState().name).toBe("Ada Lovelace");
  });

  test("who gives no name is not asked again", async () => {
    vi.stubGlobal("localStorage", storage());
    const first = await loaded();
    first.state.getState().close();
    expect((await loaded()).state.getState().name).toBe("");
  });

  test("closing the question keeps a name that is known", async () => {
    vi.stubGlobal("localStorage", storage({ "knifetip.operator": "Ada" }));
    const { state, operatorName } = await loaded();
    state.getState().change();
    state.getState().close();
    expect(state.getState()).toMatchObject({ name: "Ada", changing: false });
    expect(operatorName()).toBe("Ada");
  });

  test("has the name that an older page stored", async () => {
    vi.stubGlobal("localStorage", storage({ "knifetip.accepted-by": "Ada" }));
    expect((await loaded()).operatorName()).toBe("Ada");
  });

  test("is shortened to what the server accepts", async () => {
    vi.stubGlobal("localStorage", storage());
    const { state, operatorName } = await loaded();
    state.getState().keep("x".repeat(200));
    expect(operatorName()).toHaveLength(100);
  });

  test("is kept until the page is closed where the browser forbids storage", async () => {
    const forbidden = () => {
      throw new DOMException("denied", "SecurityError");
    };
    vi.stubGlobal("localStorage", { getItem: forbidden, setItem: forbidden });
    const { state, operatorName } = await loaded();
    expect(state.getState().name).toBeNull();
    state.getState().keep("Ada");
    expect(operatorName()).toBe("Ada");
  });
});
