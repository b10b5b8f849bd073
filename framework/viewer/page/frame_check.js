import { findingsOf } from './hypothesis_log.js';
import { coordinate, integer, list, number, object, optionalList, pose, refuse, text } from './record_error.js';

export const kStatuses = ['searching', 'ambiguous', 'localized', 'lost'];

/// What has to be right before anything of a frame record is taken, decoded. `first`: of the recording; `before`: time of the
/// frame before [s]; `features`: how many the map has.
export function checkedFrame(record, first, before, features) {
  const starts = record.start !== undefined || first;
  const time = number(record.time, 'time');
  if (!starts && time < before) refuse('time', `not before ${before}`, time);
  const status = kStatuses.indexOf(record.status);
  if (status < 0) refuse('status', kStatuses.join(', '), record.status);
  if (record.scores !== undefined) list(record.scores, 'scores');
  if (record.cpu !== undefined) object(record.cpu, 'cpu');
  if (record.search !== undefined) checkSearch(record.search);
  if (record.words !== undefined) checkWords(record.words);
  if (record.restated !== undefined) checkRestated(record.restated);
  findingsOf(record.findings, features, 'findings');
  return {
    starts,
    time,
    status,
    local: pose(record.local, 'local'),
    stamp: number(record.stamp, 'stamp'),
    keyframe: integer(record.keyframe, 'keyframe'),
    best: integer(record.best ?? -1, 'best'),
    truth: record.truth === undefined || record.truth === null ? null : pose(record.truth, 'truth'),
  };
}

function checkSearch(search) {
  object(search, 'search');
  for (const entry of optionalList(search.patterns, 'search.patterns')) {
    const [template, locals] = list(entry, 'search.patterns');
    text(template, 'search.patterns');
    list(locals, 'search.patterns').forEach((id) => integer(id, 'search.patterns'));
  }
  for (const entry of optionalList(search.rejected, 'search.rejected')) {
    const [, x, y, heading, , pairs, reason] = list(entry, 'search.rejected');
    pose([x, y, heading], 'search.rejected');
    list(pairs, 'search.rejected').forEach((pair) => list(pair, 'search.rejected'));
    text(reason, 'search.rejected');
  }
}

function checkRestated(restated) {
  object(restated, 'restated');
  text(restated.start, 'restated.start');
  for (const line of optionalList(restated.path, 'restated.path')) {
    if (list(line, 'restated.path').length % 2 !== 0) refuse('restated.path', 'pairs of x and y', line.length);
    for (const value of line) coordinate(value, 'restated.path');
  }
}

function checkWords(words) {
  for (const entry of list(words, 'words')) {
    const [kind, sentence] = list(entry, 'words');
    text(kind, 'words');
    text(sentence, 'words');
  }
}
