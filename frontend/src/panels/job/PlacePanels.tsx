/** What is seen at the place of the slider or of the picked edge: section and program lines. */

import { lazy, Suspense } from "react";
import type { Job } from "../../api/jobs";
import { translate } from "../../language/translate";
import { useTimeline } from "../../state/queries";
import { Figure, Note } from "../shared/parts";
import { Section } from "../shared/Section";
import { HeadFigures } from "./HeadFigures";

const SectionPanel = lazy(() =>
  import("./SectionPanel").then((module) => ({ default: module.SectionPanel })),
);
const ProgramLines = lazy(() =>
  import("./ProgramLines").then((module) => ({ default: module.ProgramLines })),
);

export function PlacePanels({ job }: { job: Job }) {
  const { data: timeline } = useTimeline();
  if (timeline === undefined) return null;
  const loading = <Note role="status">{translate("part.loading")}</Note>;
  return (
    <>
      <Section title={translate("sectionPanel.sectionAtThisPlace")}>
        <HeadFigures job={job} timeline={timeline} />
        <Suspense fallback={loading}>
          <SectionPanel key={job.id} job={job} timeline={timeline} />
        </Suspense>
      </Section>
      <Section
        title={translate("programLines.programLines")}
        aside={<Figure>{translate("programLines.lines", { lines: job.lines })}</Figure>}
        open={false}
      >
        <Suspense fallback={loading}>
          <ProgramLines key={job.id} job={job} timeline={timeline} />
        </Suspense>
      </Section>
    </>
  );
}
