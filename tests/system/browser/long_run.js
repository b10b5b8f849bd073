/// Records of a run whose page keeps a window, made by the program's own live feed: OPAL_SYNTHETIC_RUN.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { kFolder } from './page_file.js';

export const kMaker = process.env.OPAL_SYNTHETIC_RUN ?? '';
export const kUpdatesASecond = 4;

/// Two records of run and map, then one for each update.
export function recordsOfWindow({ seconds, window_s, hypotheses = 4, timeLines = 1 }) {
  const file = join(kFolder, `long_run_${process.pid}.jsonl`);
  const words = [file, seconds * kUpdatesASecond, hypotheses, 10, timeLines, window_s];
  execFileSync(kMaker, words.map(String));
  return readFileSync(file, 'utf8').trim().split('\n');
}
