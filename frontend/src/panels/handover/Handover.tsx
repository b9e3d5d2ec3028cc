/** What is handed over of a drawing and of a job: exported files and the job ticket. */

import { Button, Group } from "@mantine/core";
import { IconPrinter } from "@tabler/icons-react";
import { type Drawing, drawingService } from "../../api/drawings";
import { type Job, jobService } from "../../api/jobs";
import { language } from "../../language/language";
import { translate } from "../../language/translate";
import { hasProgram } from "../../state/job/jobs";
import { ExportMenu } from "./ExportMenu";

/** Opens the job ticket, to be printed, in the language of the page. */
export function TicketButton({ job, size = "xs" }: { job: Job; size?: "xs" | "lg" }) {
  return (
    <Button
      component="a"
      href={jobService.ticketUrl(job.id, language)}
      target="_blank"
      rel="noopener"
      size={size}
      variant={size === "lg" ? "default" : "subtle"}
      color="gray"
      leftSection={<IconPrinter size={size === "lg" ? 22 : 15} aria-hidden />}
      data-testid="ticket"
    >
      {translate("handover.jobTicket")}
    </Button>
  );
}

/** The ticket of a job and, once it is compiled, its compensated path. */
export function JobHandover({ job }: { job: Job }) {
  return (
    <Group gap={8}>
      <TicketButton job={job} />
      {hasProgram(job) && (
        <ExportMenu
          label={translate("handover.exportPath")}
          testId="export-path"
          urlOf={(format) => jobService.pathExportUrl(job.id, format)}
        />
      )}
    </Group>
  );
}

export function DrawingExport({ drawing }: { drawing: Drawing }) {
  return (
    <ExportMenu
      label={translate("handover.exportDrawing")}
      testId="export-drawing"
      urlOf={(format) => drawingService.drawingExportUrl(drawing.id, format)}
    />
  );
}
