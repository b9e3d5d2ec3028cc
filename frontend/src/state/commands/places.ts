/** The places of the rail, as the command palette lists them. */

import { navigate } from "wouter/use-hash-location";
import { translate } from "../../language/translate";
import { returnToDrawing, STATIONS, WORK } from "../routes";

interface Place {
  readonly id: string;
  readonly title: string;
  show(): void;
}

const place = (id: string, title: string, path: string): Place => ({
  id,
  title,
  show: () => navigate(path),
});

export const PLACES: readonly Place[] = [
  place("work", translate("rail.work"), WORK),
  { id: "drawing", title: translate("rail.drawing"), show: returnToDrawing },
  place("machines", translate("rail.machines"), "/machines"),
  place("station", translate("rail.station"), STATIONS),
  place("library", translate("rail.library"), "/library"),
  place("history", translate("rail.history"), "/history"),
  place("settings", translate("rail.settings"), "/settings"),
];
