/**
 * Moves an axis while a button is held down.
 *
 * The machine gets one short move after another, never a long one: if the page, the network or the
 * tablet fails while the button is down, the machine stops by itself at the end of a short move.
 */

import type { Outcome } from "./station";

export interface JogCommands {
  /** Begin the next short move; null if there is none, as at the limit of the travel. */
  move(): Promise<Outcome> | null;
  stop(): Promise<unknown>;
  /** Whether the machine has come to rest after its last move. */
  isAtRest(): boolean;
}

/** Time between two checks of the state of the machine (ms). */
const LOOK = 60;
/** Looks after which a machine that has taken a move, but reports no motion, counts as at rest. */
const PATIENT_LOOKS = 8;

const sleep = (milliseconds: number): Promise<void> =>
  new Promise((resolve) => setTimeout(resolve, milliseconds));

export class HeldJog {
  private held = false;

  constructor(private readonly commands: JogCommands) {}

  /** Move until `release`, the limit of the travel, or a refusal. */
  async hold(): Promise<void> {
    if (this.held) return;
    this.held = true;
    while (this.held) {
      const move = this.commands.move();
      if (move === null) break;
      const outcome = await move;
      if (!this.held) {
        // Released while the move was on its way.
        await this.commands.stop();
        return;
      }
      if (outcome.state !== "done") break;
      await this.untilRest();
    }
    this.held = false;
  }

  /** Stop; does nothing if the button is not held. */
  release(): void {
    if (!this.held) return;
    this.held = false;
    void this.commands.stop();
  }

  private async untilRest(): Promise<void> {
    let moved = false;
    for (let looks = 0; this.held; looks++) {
      const rest = this.commands.isAtRest();
      if (!rest) moved = true;
      else if (moved || looks >= PATIENT_LOOKS) return;
      await sleep(LOOK);
    }
  }
}
