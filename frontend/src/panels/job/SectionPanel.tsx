/** The section of the board at the place of the slider or of the picked edge. */

import { Text } from "@mantine/core";
import { useDebouncedValue } from "@mantine/hooks";
import { keepPreviousData, useQuery } from "@tanstack/react-query";
import type { EdgeSection, Job, ToolSection } from "../../api/jobs";
import type { Timeline } from "../../geometry/timeline";
import { translate } from "../../language/translate";
import { errorText } from "../../messages/translateMessage";
import { formatDeviation } from "../../state/format";
import { useEdgeAtPlace } from "../../state/job/place";
import { closesEarly, measuresOf } from "../../state/job/section";
import { queries } from "../../state/queries";
import { Note } from "../shared/parts";
import css from "./check.module.css";
import { measureText, measureTitle } from "./measureTexts";
import { SectionPicture } from "./SectionPicture";

/** While the program plays, edges that are passed at once are not fetched (ms). */
const PATIENCE = 120;

interface Props {
  readonly job: Job;
  readonly timeline: Timeline;
}

export function SectionPanel({ job, timeline }: Props) {
  const [edge] = useDebouncedValue(useEdgeAtPlace(timeline), PATIENCE);
  const { data: section, error } = useQuery({
    ...queries.section(job.id, edge),
    enabled: edge >= 0,
    placeholderData: keepPreviousData,
  });
  if (edge < 0) return <Note>{translate("sectionPanel.chooseAnEdge")}</Note>;
  if (error !== null) return <Note>{errorText(error)}</Note>;
  if (section === undefined) return <Note role="status">{translate("part.loading")}</Note>;
  return (
    <div data-testid="section" data-edge={section.edge}>
      {section.tools.length === 0 && (
        <Note>{translate("sectionPanel.noToolMakesTheEdge", { edge: section.edge })}</Note>
      )}
      {section.made_as >= 0 && section.made_as !== section.edge && (
        <Note mb={6}>
          {translate("sectionPanel.madeWithEdge", {
            edge: section.edge,
            other: section.made_as,
          })}
        </Note>
      )}
      {section.tools.map((tool) => (
        <Tool key={tool.station} section={section} tool={tool} />
      ))}
    </div>
  );
}

function Tool({ section, tool }: { section: EdgeSection; tool: ToolSection }) {
  const measures = measuresOf(section, tool);
  const isShort = closesEarly(section, tool);
  return (
    <>
      <Text fz={13} fw={600} c="ink.0">
        {translate("sectionPanel.edgeByTool", { edge: section.edge, tool: tool.name })}
      </Text>
      <SectionPicture caliper={section.caliper} tool={tool} measures={measures} />
      <table className={css.measures} data-testid="section-measures">
        <caption className={css.hidden}>
          {translate("sectionPanel.measuresOf", { edge: section.edge, tool: tool.name })}
        </caption>
        <tbody>
          {measures.map((measure) => (
            <tr key={measure.name} data-measure={measure.name}>
              <th scope="row">
                <span className={css.letter}>{measure.letter}</span>
                {measureTitle(measure, tool)}
              </th>
              <td data-tone={measure.name === "foldAngle" && isShort ? "amber" : undefined}>
                {measureText(measure)}
              </td>
            </tr>
          ))}
          <Verified section={section} tool={tool} />
        </tbody>
      </table>
    </>
  );
}

/** Figures of the verifier that are stated even if they are 0, by the shape of the tool's mark. */
const ALWAYS: Readonly<Record<ToolSection["shape"], readonly string[]>> = {
  groove: ["deviation", "flank", "overcut"],
  wheel: ["deviation", "setback"],
  line: ["deviation", "overcut"],
  disc: ["deviation", "overcut"],
};

const FIGURES = {
  deviation: translate("sectionPanel.deviation"),
  flank: translate("sectionPanel.flank"),
  overcut: translate("sectionPanel.overcut"),
  top_overcut: translate("sectionPanel.topOvercut"),
  bottom_uncut: translate("sectionPanel.bottomUncut"),
  uncut: translate("sectionPanel.uncut"),
  setback: translate("sectionPanel.setback"),
  slit_length: translate("sectionPanel.slitLength"),
} as const;

/** Lengths below this (mm) are not listed, except those that every section lists. */
const LISTED = 0.005;

function Verified({ section: { figures }, tool }: { section: EdgeSection; tool: ToolSection }) {
  return Object.entries(FIGURES).map(([name, title]) => {
    const value = figures[name];
    if (value === undefined || (value < LISTED && !ALWAYS[tool.shape].includes(name))) return null;
    return (
      <tr key={name} data-measure={name}>
        <th scope="row">
          <span className={css.letter} />
          {title}
        </th>
        <td>
          {name === "deviation" ? formatDeviation(value) : measureText({ value, unit: "mm" })}
        </td>
      </tr>
    );
  });
}
