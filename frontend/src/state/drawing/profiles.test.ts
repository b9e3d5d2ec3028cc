import { expect, test } from "vitest";
import { useUiStore } from "../store";
import { showSaved } from "./profiles";

test("the editor shows a saved profile only while it is still open on the edited one", () => {
  const { set } = useUiStore.getState();
  const edited = () => useUiStore.getState().editedProfile;
  set({ editedProfile: "default" });
  showSaved("acme", "default");
  expect(edited()).toBe("acme");
  // The user went back to the drawing, or opened another profile, while the file was saved.
  set({ editedProfile: null });
  showSaved("acme", "default");
  expect(edited()).toBeNull();
  set({ editedProfile: "bolt" });
  showSaved("acme", "default");
  expect(edited()).toBe("bolt");
});
