import { Recording } from './recording.js';
import { RecordError } from './record_error.js';

const kBatch_ms = 60;
const kBeginsRun = /^\s*\{\s*"r"\s*:\s*"run"/;

/// Records as a server sends them. They are taken in batches, so that a fast run costs the page no more than a slow one.
/// A connection that comes back goes on where it was, or tells the run from its first record on; then a new recording replaces the old one.
/// `on` has: recording(recording) for the first and every replacing one, appended(recording), state(name, words).
export class LiveFeed {
  constructor(url, on) {
    this.on = on;
    this.waiting = [];
    this.recording = null;
    this.timer = 0;
    this.source = new EventSource(url);
    this.source.onmessage = (message) => this.queue(message.data);
    this.source.onopen = () => on.state('live', 'Live');
    this.source.addEventListener('end', () => this.close('over', 'The run is over'));
    this.source.onerror = () => this.broken();
  }

  broken() {
    if (this.source.readyState === EventSource.CLOSED) this.close('broken', 'The connection to the run is broken');
    else this.on.state('waiting', 'Connection lost; trying again');
  }

  close(name, words) {
    this.source.close();
    this.flush();
    if (!this.failed) this.on.state(name, words);
  }

  queue(data) {
    for (const line of data.split('\n')) if (line !== '') this.waiting.push(line);
    if (!this.timer) this.timer = setTimeout(() => this.flush(), kBatch_ms);
  }

  flush() {
    clearTimeout(this.timer);
    this.timer = 0;
    const lines = this.waiting;
    this.waiting = [];
    const before = this.recording?.frames ?? 0;
    try {
      for (const line of lines) this.take(line);
    } catch (error) {
      if (!(error instanceof RecordError)) throw error;
      this.failed = true;
      this.source.close();
      this.on.state('broken', error.message);
    }
    if (this.recording && this.recording.frames !== before) this.on.appended(this.recording);
  }

  take(line) {
    if (!this.recording || (kBeginsRun.test(line) && this.recording.records > 0)) {
      this.recording = new Recording('live');
      this.on.recording(this.recording);
    }
    this.recording.append(line);
  }
}
