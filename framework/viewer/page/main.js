import { App } from './app.js';
import { readDataBlock } from './data_block.js';
import { inspectionOf } from './inspection.js';
import { LiveFeed } from './live_feed.js';
import { Recording } from './recording.js';

const kMostRuns = 2;
const errors = [];
const app = new App(document.getElementById('opal'));
const progress = document.getElementById('progress');

function complain(words) {
  errors.push(words);
  app.header.alert(words);
}

async function readBlocks(blocks) {
  const recordings = [];
  for (const [k, block] of blocks.entries()) {
    const name = block.dataset.name || `run ${k + 1}`,
      recording = new Recording(name);
    progress.textContent = `Reading ${name} …`;
    const error = await readDataBlock(
      block,
      recording,
      ({ frames }) => (progress.textContent = `Reading ${name}: ${frames} updates`),
    );
    if (error) complain(`${name}: ${error.message}. ${recording.frames} updates before it are shown.`);
    if (recording.map) recordings.push(recording);
  }
  progress.hidden = true;
  if (recordings.length === 0) return;
  app.setRecordings(recordings);
  app.start();
}

function follow(url) {
  progress.textContent = 'Waiting for the first update …';
  app.transport.newest.hidden = false;
  if (!location.hash.includes('t=')) app.state.newest = true;
  let dead = '';
  const feed = new LiveFeed(url, {
    recording: (recording) => {
      feed.shown = false;
      feed.fresh = recording;
    },
    younger: (recording) => feed.shown && app.replaceRecording(recording),
    appended: (recording) => {
      if (!feed.shown) show(recording);
      else app.dataChanged();
    },
    state: (name, words) => {
      app.header.setLive(name, name === 'live' ? 'Live' : words);
      if (name === 'broken' && dead !== words) complain((dead = words));
    },
  });
  const show = (recording) => {
    feed.shown = true;
    progress.hidden = true;
    app.setRecordings([recording]);
    if (!app.started) app.start();
    app.dataChanged();
  };
}

async function start() {
  const blocks = [...document.querySelectorAll('script.opal-run')].slice(0, kMostRuns);
  const live = document.querySelector('meta[name="opal-live"]');
  if (live) follow(live.content);
  else if (blocks.length > 0) await readBlocks(blocks);
  else complain('This page has no data: expected a script of class opal-run, or a live address.');
  progress.hidden ||= !live;
}

window.opal = inspectionOf(
  app,
  start().catch((error) => complain(`The page failed: ${error.message}`)),
  errors,
);
