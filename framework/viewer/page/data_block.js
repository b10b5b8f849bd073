import { RecordError } from './record_error.js';

const kBase64Step = 1 << 20; ///< characters at a time, a multiple of 4
const kLongestTask_ms = 40; ///< then the browser may paint

function bytesOf(base64) {
  const text = base64.replace(/\s+/g, '');
  const parts = [];
  try {
    for (let at = 0; at < text.length; at += kBase64Step) {
      const binary = atob(text.slice(at, at + kBase64Step));
      const bytes = new Uint8Array(binary.length);
      for (let k = 0; k < binary.length; ++k) bytes[k] = binary.charCodeAt(k);
      parts.push(bytes);
    }
  } catch {
    return { parts, error: new RecordError('data block: expected base64, found other characters; what is before them is shown') };
  }
  return { parts, error: null };
}

const pause = () => new Promise((resolve) => setTimeout(resolve));

/// Reads a data block (base64 of gzip of records) into a recording, with pauses for the browser. Returns the error that
/// stopped it, or null; what was read until then stays.
export async function readDataBlock(element, recording, progress) {
  const { parts, error } = bytesOf(element.textContent);
  element.textContent = '';
  if (error && parts.length === 0) return error;
  const stream = new Blob(parts).stream().pipeThrough(new DecompressionStream('gzip')).pipeThrough(new TextDecoderStream());
  try {
    await readLines(stream.getReader(), recording, progress);
  } catch (problem) {
    if (problem instanceof RecordError) return problem;
    return new RecordError(`data block: expected gzip, found damage after record ${recording.records}: ${problem.message}`);
  }
  return error ?? (recording.frames > 0 ? null : new RecordError('data block: expected updates, found none'));
}

async function readLines(reader, recording, progress) {
  let rest = '',
    since = performance.now();
  for (;;) {
    const { value, done } = await reader.read();
    const lines = (rest + (value ?? '')).split('\n');
    rest = done ? '' : lines.pop();
    for (const line of lines) {
      if (line.trim() !== '') recording.append(line);
      if (performance.now() - since < kLongestTask_ms) continue;
      progress(recording);
      await pause();
      since = performance.now();
    }
    if (done) return;
  }
}
