/// A map with evidence of two drives, and `opal map review` on them: files in a folder of their own.
import { execFileSync, spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';
import { kFolder } from './page_file.js';

const kRoot = join(dirname(fileURLToPath(import.meta.url)), '../../..');
export const kScript = '<img src=x onerror=alert(1)><script>alert(2)</script>';

const seen = (object, verdict, x = 0, y = 0, observations = 12) => ({
  object,
  type: 'opal:Wall',
  verdict,
  moved_x_m: x,
  moved_y_m: y,
  offset_m: Math.hypot(x, y),
  sigma_m: 0.03,
  observations,
  seen_through_share: verdict === 'probably absent' ? 0.9 : 0,
});
const face = { begin_x_m: 2, begin_y_m: 2.5, end_x_m: 3.5, end_y_m: 2.5, views: 10, seen_through_share: 0 };

const driveOf = (name, where_m, more) => ({
  opal_evidence: 1,
  map: 'Example room',
  drive: name,
  learned_m: 20,
  left_out_m: 0,
  visits: [
    {
      objects: [
        seen('south_wall', 'moved', 0, 0.3),
        seen('column_1', 'probably absent'),
        seen('west_wall', 'moved', where_m, 0),
        ...more,
      ],
      unmapped: [face],
    },
  ],
});

/// Whatever a person reads has markup in it.
export function madeReview() {
  const folder = mkdtempSync(join(kFolder, 'review-'));
  const map = JSON.parse(readFileSync(join(kRoot, 'maps/example_room.jsonld'), 'utf8'));
  map['@graph'].find((node) => node['@id'] === 'south_wall').name = `South ${kScript}`;
  writeFileSync(join(folder, 'room.jsonld'), JSON.stringify(map));
  const doubtful = [seen('east_wall', 'moved', -0.2, 0, 5)];
  const drives = [driveOf(`monday ${kScript}`, 0.6, doubtful), driveOf('tuesday', -0.5, [])];
  writeFileSync(join(folder, 'evidence.json'), JSON.stringify(drives));
  return folder;
}

const opalOf = () => process.env.OPAL_PROGRAM;

export function opal(folder, ...words) {
  return execFileSync(opalOf(), words, { cwd: folder, stdio: 'pipe' }).toString();
}

/// The program with its page; `end()` is Ctrl-C, `kill()` is the end without a word.
export async function serveReview(folder) {
  const program = spawn(opalOf(), ['map', 'review', 'room.jsonld', 'evidence.json', '-o', 'reviewed.jsonld', '--port', '0'], {
    cwd: folder,
  });
  const gone = once(program, 'exit');
  let address;
  for await (const line of createInterface({ input: program.stdout })) {
    address = line.match(/http:\S+/)?.[0];
    if (address) break;
  }
  const stop = async (signal) => {
    program.kill(signal);
    return (await gone)[0];
  };
  return { address, end: () => stop('SIGINT'), kill: () => stop('SIGKILL') };
}

export const readJson = (folder, name) => JSON.parse(readFileSync(join(folder, name), 'utf8'));

/// What an overlay changes and adds, by id.
export function changedBy(folder, name) {
  const [{ changes }, ...added] = readJson(folder, name)['@graph'];
  return [...changes.map(({ target }) => target), ...added.map((node) => node['@id'])].sort();
}
