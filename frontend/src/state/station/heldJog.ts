/**
 * Moves an axis while a button is held down.
 *
 * The machine moves only as long as it is stated again and again that the button is held: if the
 * page, the network or the tablet fails while the button is down, the machine stops by itself.
 */

export interface JogCommands {
  /** Begin the move; its id, or null if it was refused or there is none, as at the limit. */
  begin(): Promise<string | null>;
  /** State that the button is still held; false: the move has ended. */
  renew(id: string): Promise<boolean>;
  stop(): Promise<unknown>;
}

/** Time between two statements that the button is held (ms). */
const RENEWAL = 300;

const sleep = (milliseconds: number): Promise<void> =>
  new Promise((resolve) => setTimeout(resolve, milliseconds));

export class HeldJog {
  private held = false;

  constructor(private readonly commands: JogCommands) {}

  /** Move until `release`, the end of the distance, or a refusal. */
  async hold(): Promise<void> {
    if (this.held) return;
    this.held = true;
    const id = await this.commands.begin();
    if (id === null) {
      this.held = false;
      return;
    }
    if (!this.held) {
      // Released while the move was on its way.
      await this.commands.stop();
      return;
    }
    while (this.held) {
      await sleep(RENEWAL);
      // Not awaited: a slow answer must not delay the next statement.
      if (this.held) void this.renew(id);
    }
  }

  /** Stop; does nothing if the button is not held. */
  release(): void {
    if (!this.held) return;
    this.held = false;
    void this.commands.stop();
  }

  private async renew(id: string): Promise<void> {
    if (!(await this.commands.renew(id))) this.held = false;
  }
}
