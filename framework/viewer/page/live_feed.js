import { Recording } from './recording.js';
import { RecordError } from './record_error.js';

const kBatch_ms = 60;
const kBeginsRun = /^\s*\{\s*"r"\s*:\s*"run"/;

/// Records as a server sends them. They are taken in batches, so that a fast run costs the page no more than a slow one.
/// A connection that comes back goes on where it was, or tells the run from its first record on; then a new recording replaces the old one.
/// If the run goes on for longer than can be kept, a younger recording of the same run takes over from time to time.
/// `on` has: recording(recording) for the first one and that of another run, younger(recording), appended(recording), state(name, words).
export class LiveFeed {
  constructor(url, on) {
    this.on = on;
    this.waiting = [];
    this.kept = null;
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
    this.grown = this.replaced = false;
    try {
      for (const line of lines) this.take(line);
    } catch (error) {
      if (!(error instanceof RecordError)) throw error;
      this.failed = true;
      this.source.close();
      this.on.state('broken', error.message);
    }
    if (this.replaced) this.on.younger(this.kept.recording);
    if (this.grown) this.on.appended(this.kept.recording);
  }

  take(line) {
    if (!this.kept || (kBeginsRun.test(line) && this.kept.recording.records > 0)) {
      this.kept = new KeptWindow('live');
      this.replaced = false;
      this.on.recording(this.kept.recording);
    }
    this.replaced = this.kept.append(line) || this.replaced;
    this.grown = this.kept.recording.frames > 0;
  }
}

/// A recording of a run that may go on for months. Where the run record names a window, the recording is replaced by a
/// younger one from time to time, so that it always holds the newest window (if there is so much), and less than two.
export class KeptWindow {
  constructor(name) {
    this.name = name;
    this.recording = new Recording(name);
    this.next = null; ///< will replace it
    this.first = []; ///< records of run and map
  }

  /// Throws RecordError. Returns whether the recording was replaced.
  append(line) {
    this.recording.append(line);
    const { header, frames } = this.recording;
    if (frames === 0) this.first.push(line);
    if (!header?.window || frames === 0) return false;
    if (this.next) this.next.append(line);
    else if (frames > 1 && this.recording.newestBegins) this.begin(line);
    if (!this.next || !isFilled(header.window, this.next)) return false;
    this.recording = this.next;
    this.next = null;
    return true;
  }

  begin(line) {
    this.next = new Recording(this.name);
    for (const record of [...this.first, line]) this.next.append(record);
  }
}

function isFilled(window, { lasts_s, characters }) {
  return lasts_s >= (window.seconds ?? Infinity) || characters >= (window.characters ?? Infinity);
}
