/// Packs pages as `opal view` does, with the same marks, data blocks and security policy.
import { execFileSync } from 'node:child_process';
import { randomBytes } from 'node:crypto';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

export const kPageFolder = join(dirname(fileURLToPath(import.meta.url)), '../../../framework/viewer/page');
export const kFolder = mkdtempSync(join(tmpdir(), 'opal-viewer-'));
let script = null;

function bundle() {
  if (script !== null) return script;
  const out = join(kFolder, 'page.js');
  execFileSync('sh', [join(kPageFolder, 'bundle.sh'), out]);
  return (script = readFileSync(out, 'utf8'));
}

export const packed = (lines) => gzipSync(lines.map((line) => `${line}\n`).join(''));

const escaped = (text) => text.replace(/&/g, '&amp;').replace(/"/g, '&quot;').replace(/</g, '&lt;');

/// A data block of lines, or of bytes as they are.
export function dataBlock(data, name = 'out') {
  const bytes = Array.isArray(data) ? packed(data) : data;
  return `<script type="text/plain" class="opal-run" data-name="${escaped(name)}">${bytes.toString('base64')}</script>`;
}

export function pageWith(data) {
  const nonce = randomBytes(16).toString('base64');
  const policy = `default-src 'none'; style-src 'nonce-${nonce}'; script-src 'nonce-${nonce}'; connect-src 'self'; img-src data: blob:`;
  const marks = {
    '<!-- opal:style -->': `<meta http-equiv="Content-Security-Policy" content="${policy}">\n<style nonce="${nonce}">${readFileSync(join(kPageFolder, 'style.css'), 'utf8')}</style>`,
    '<!-- opal:data -->': data,
    '<!-- opal:script -->': `<script nonce="${nonce}">${bundle()}</script>`,
  };
  return readFileSync(join(kPageFolder, 'index.html'), 'utf8').replace(/<!-- opal:\w+ -->/g, (mark) => marks[mark]);
}

/// Writes a page of such runs ([lines, name] each); returns its file: address.
export function writePage(name, ...runs) {
  const path = join(kFolder, `${name}.html`);
  writeFileSync(path, pageWith(runs.map(([data, title]) => dataBlock(data, title)).join('\n')));
  return `file://${path}`;
}

/// The data of a page that `opal view` wrote, in a page of these sources.
export function repack(file) {
  const path = join(kFolder, 'repacked.html');
  writeFileSync(
    path,
    pageWith(
      readFileSync(file, 'utf8')
        .match(/<script type="text\/plain"[^>]*>[^<]*<\/script>/g)
        .join('\n'),
    ),
  );
  return `file://${path}`;
}
