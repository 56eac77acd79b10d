import { PieceReader, ReplayError } from '../data/pieces.js';

const FIRST_WAIT_MS = 500, LONGEST_WAIT_MS = 10000;

/**
 * Follows a run over the address from which the page came. It connects again where the stream breaks off.
 * Event `status`: `state` is one of `connecting`, `open`, `lost`, `ended`, `failed`.
 */
export class LiveSource extends EventTarget {
  #recording;
  #token;

  constructor(recording, token) {
    super();
    this.#recording = recording;
    this.#token = token;
    this.state = 'connecting';
    this.message = '';
  }

  /** Reads until the run ends. */
  async follow() {
    for (let wait = FIRST_WAIT_MS;;) {
      const before = this.#recording.end;
      try {
        await this.#read();
      } catch (error) {
        if (error instanceof ReplayError || error.isRefusal) return this.#tell('failed', error.message);
      }
      if (this.#recording.endReason) return this.#tell('ended', this.#recording.endReason);
      if (this.#recording.end > before) wait = FIRST_WAIT_MS;
      this.#tell('lost', 'The connection to the run was lost. The page tries to connect again.');
      await new Promise((resolve) => setTimeout(resolve, wait));
      wait = Math.min(2 * wait, LONGEST_WAIT_MS);
    }
  }

  async #read() {
    const response = await fetch(this.#address('events'), { cache: 'no-store' });
    if (!response.ok) {
      throw Object.assign(new Error(`The run refused the page (${response.status} ${response.statusText}). ` +
        'Open the address that the program printed, with its token.'), { isRefusal: response.status < 500 });
    }
    this.#tell('open', '');
    const reader = new PieceReader(), stream = response.body.getReader();
    for (;;) {
      const { done, value } = await stream.read();
      if (done) return;
      await this.#recording.add(reader.push(value));
    }
  }

  /** Asks the run to pause, resume, step or slow down. @param {'pause'|'resume'|'step'|'slow'} action */
  async control(action, factor) {
    const response = await fetch(this.#address('control'), {
      method: 'POST', headers: { 'Content-Type': 'application/json' },
      body: JSON.stringify(factor === undefined ? { action } : { action, factor }),
    });
    if (!response.ok) throw new Error(`The run did not take the command (${response.status}).`);
  }

  #address(name) { return `${name}?token=${encodeURIComponent(this.#token)}`; }

  #tell(state, message) {
    this.state = state;
    this.message = message;
    this.dispatchEvent(new Event('status'));
  }
}
