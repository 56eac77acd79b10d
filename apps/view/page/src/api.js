import { compose, shoot } from './pictures.js';

/**
 * `window.nilas`: for tests and for scripts that make pictures. All times in seconds, forces in newtons.
 * @param {() => import('./app.js').App|null} app
 * @param {{ready: Promise<void>, marks: Record<string, number>}} progress
 */
export function makeApi(app, progress) {
  return {
    /** Resolves when the replay was read and its first picture drawn. */
    ready: progress.ready,
    get frameCount() { return app() ? app().recording.end - app().recording.first : 0; },
    get time() { return app().player.time; },
    get frame() { return app().player.number - app().recording.first; },
    get notices() { return app().notices.texts; },
    seek: (time, how) => stay(app).seek(time, how),
    seekFrame: (number) => stay(app).seekFrame(app().recording.first + number),
    play: () => app().player.play(),
    pause: () => app().player.pause(),
    set: (option, value) => app().options.set(option, value),
    options: () => app().options.all(),
    pick: (id) => app().pick(id),
    pickAt: (x, y) => app().pickAt(x, y),
    state: () => ({ time: app().player.time, frame: app().player.number - app().recording.first, ...app().world.state(),
                    graphs: app().graphs?.shown ?? [] }),
    stats: () => stats(app(), progress),
    capture: () => app().stage.capture(),
    /** The times of the first and the last frame. */
    get span() { return [app().recording.startTime, app().recording.endTime]; },
    /** Whether the scene has a <view>. */
    get hasView() { return Boolean(app().recording.head.view); },
    compose: (words, isPlain) => compose(app(), words, isPlain),
    shoot: (time, between) => shoot(app(), time, between),
    measure: (count) => measure(app(), count),
  };
}

/** The player, which then no longer follows a live run: its next frame would overtake the one that is sought. */
function stay(app) {
  app().player.leaveLive();
  return app().player;
}

function stats({ stage, store, recording }, { marks }) {
  const { render, memory } = stage.renderer.info;
  return {
    drawCalls: render.calls, triangles: render.triangles, lines: render.lines, geometries: memory.geometries, fps: stage.picturesPerSecond,
    decodeMs: store.numDecoded > 0 ? store.decodeMs / store.numDecoded : 0, decoded: store.numDecoded, cacheBytes: store.cacheBytes,
    cachedFrames: store.cachedFrames, packedBytes: recording.packedBytes, skippedKinds: [...recording.skippedKinds], ...marks,
    heapBytes: performance.memory?.usedJSHeapSize ?? null,
  };
}

/** Shows `count` frames one after the other as fast as it goes, and returns the mean times of a frame [ms]. */
async function measure({ player, stage, recording }, count) {
  const size = recording.end - recording.first, start = performance.now();
  let draw = 0;
  for (let i = 0; i < count; ++i) {
    await player.seekFrame(recording.first + i % size);
    const before = performance.now();
    stage.draw();
    stage.finish();
    draw += performance.now() - before;
  }
  const whole = performance.now() - start;
  return { frameMs: whole / count, drawMs: draw / count, framesPerSecond: 1000 * count / whole };
}
