import 'uplot/dist/uPlot.min.css';
import { makeApi } from './api.js';
import { App } from './app.js';
import { ReplayError } from './data/pieces.js';
import { Recording } from './data/recording.js';
import { embeddedBlocks, readEmbedded, readFile } from './sources/embedded.js';
import { LiveSource } from './sources/live.js';
import { el } from './ui/dom.js';

/** So much of a live run is kept [bytes, packed]. */
const MAX_LIVE_BYTES = 400e6;

let app = null;
const marks = {};
let tellReady, tellFault;
const ready = new Promise((resolve, reject) => {
  tellReady = resolve;
  tellFault = reject;
});
// Who does not wait for `ready` sees the fault on the page.
ready.catch(() => {});
window.nilas = makeApi(() => app, { ready, marks });

function readFacts() {
  const text = document.getElementById('nilas-facts').textContent.trim();
  return text.startsWith('{') ? JSON.parse(text) : {};
}

/** Starts the page at the first frame that comes. Resolves when it is drawn. */
function startAtFirstFrame(recording) {
  return new Promise((resolve, reject) => {
    recording.addEventListener('grown', () => {
      app.start().then(() => {
        marks.firstPictureMs = performance.now();
        resolve();
      }, reject);
    }, { once: true });
  });
}

/** Reads a replay with `read`, and says what is wrong with it. */
async function showReplay(facts, recording, read) {
  const started = startAtFirstFrame(recording);
  let outcome;
  try {
    outcome = await Promise.race([read(), started.then(() => new Promise(() => {}))]);
  } catch (error) {
    if (recording.isEmpty) throw error;
    await started;
    outcome = { fault: error };
  }
  if (recording.isEmpty) throw new ReplayError('This replay has no frames. The run wrote none, or the file was cut before the first one.');
  await started;
  app.controls.refresh();
  app.graphs.refresh();
  // A time of the fragment may lie in the last block.
  await app.applyFragment();
  const { notices } = app;
  if (outcome.fault) {
    notices.show('cut', `A part of the replay could not be read (${faultText(outcome.fault)}). It is shown up to ${recording.endTime.toFixed(2)} s.`, true);
  } else if (!outcome.isCut && !recording.endReason) {
    notices.show('cut', `The replay does not say how the run ended. The run still goes on, or it was killed. It is shown up to ${recording.endTime.toFixed(2)} s.`);
  } else if (outcome.isCut) {
    notices.show('cut', `The replay ends in the middle of a piece, at ${recording.endTime.toFixed(2)} s. The run was killed, still goes on, or the file was not copied whole.`);
  }
  if (recording.skippedKinds.size > 0) {
    notices.show('kinds', `This page skipped parts of the replay that it does not know: ${[...recording.skippedKinds].join(', ')}.`);
  }
  marks.readyMs = performance.now();
}

function faultText(error) { return error.message.replace(/\.$/, ''); }

async function showLive(facts, recording, live) {
  const { notices } = app;
  live.addEventListener('status', () => {
    if (live.state === 'open') notices.hide('live');
    else notices.show('live', live.message, live.state === 'failed');
    if (live.state === 'ended') app.player.leaveLive();
  });
  app.player.isLive = true;
  const started = startAtFirstFrame(recording);
  const followed = live.follow();
  await Promise.race([started, followed.then(() => started)]);
  await app.applyFragment();
  marks.readyMs = performance.now();
}

/** A page without a replay asks for a file. */
function askForFile(facts) {
  const box = document.getElementById('stage');
  return new Promise((resolve, reject) => {
    const take = (file) => {
      if (!file) return;
      message.remove();
      const recording = new Recording();
      app = new App(facts, recording, null);
      showReplay(facts, recording, () => readFile(file, recording)).then(resolve, reject);
    };
    const input = el('input', { type: 'file', accept: '.bin', change: () => take(input.files[0]) });
    const message = el('div', { class: 'message' }, 'Choose the replay of a run, replay.bin, or drop it here.', input);
    box.append(message);
    document.addEventListener('dragover', (event) => event.preventDefault());
    document.addEventListener('drop', (event) => {
      event.preventDefault();
      take(event.dataTransfer.files[0]);
    });
  });
}

/** Says in the middle of the page why nothing is shown. */
function showFault(error) {
  const box = document.getElementById('stage');
  box.replaceChildren(el('div', { class: 'message' }, error.message));
}

async function main() {
  const facts = readFacts();
  if (facts.title) document.title = facts.title;
  const blocks = embeddedBlocks();
  if (!facts.live && blocks.length === 0) return askForFile(facts);
  const recording = new Recording(facts.live ? MAX_LIVE_BYTES : Infinity);
  const live = facts.live ? new LiveSource(recording, facts.token ?? '') : null;
  try {
    app = new App(facts, recording, live);
  } catch (error) {
    throw new Error(`The browser has no WebGL, so the page cannot draw (${faultText(error)}). Allow it in the browser's settings.`);
  }
  return live ? showLive(facts, recording, live) : showReplay(facts, recording, () => readEmbedded(blocks, recording));
}

main().then(tellReady, (error) => {
  if (!(error instanceof ReplayError)) console.warn(error);
  showFault(error);
  tellFault(error);
});
