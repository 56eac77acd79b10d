import * as THREE from 'three';
import { FrameStore } from './data/frame_store.js';
import { Recording } from './data/recording.js';
import { parseFragment } from './fragment.js';
import { Options, unknownOption } from './options.js';
import { Player } from './player.js';
import { pickBody } from './scene/picking.js';
import { BodyKind } from './data/frame.js';
import { Stage } from './scene/stage.js';
import { World } from './scene/world.js';
import { TimeBars } from './ui/bars.js';
import { Card, describeBody } from './ui/card.js';
import { Controls } from './ui/controls.js';
import { el, isNarrow } from './ui/dom.js';
import { FactsBar } from './ui/facts.js';
import { Graphs } from './ui/graphs.js';
import { fillHelp } from './ui/help.js';
import { listenToKeys } from './ui/keys.js';
import { Legend } from './ui/legend.js';
import { Notices } from './ui/notices.js';
import { Panel } from './ui/panel.js';

const byId = (id) => document.getElementById(id);
/** A press that moves less than this is a click [pixels]. */
const CLICK_PIXELS = 5;

/** The whole page: it joins the recording, the picture and what the user sees around it. */
export class App {
  picked = null;

  /**
   * @param {{title?: string, live?: boolean}} facts
   * @param {Recording} recording
   * @param {import('./sources/live.js').LiveSource|null} live
   */
  constructor(facts, recording, live) {
    Object.assign(this, { facts, recording, live });
    this.notices = new Notices(byId('notices'));
    this.options = new Options();
    this.stage = new Stage(byId('stage'));
    this.store = new FrameStore(recording);
    this.world = new World(this.stage, recording, this.options);
    this.player = new Player(recording, this.store, this.world);
    if (isNarrow()) for (const name of ['graphs', 'panel']) this.options.set(name, false);
    this.options.addEventListener('change', (event) => this.#applyOption(event.detail));
  }

  /** Builds the page around the first frame, and draws it. */
  async start() {
    const { head } = this.recording, first = await this.store.get(this.recording.first);
    this.world.setFirst(first);
    this.world.show(first);
    this.#takeView(head.view);
    this.#buildPage();
    for (const name of ['graphs', 'timings', 'panel', 'color']) this.#applyOption(name);
    this.options.set('view', 'scene');
    this.player.addEventListener('shown', () => this.#afterShown());
    this.player.addEventListener('fault', (event) => this.notices.show('frame', event.detail, true));
    await this.player.seek(this.player.isLive ? this.recording.endTime : this.recording.startTime);
    window.addEventListener('hashchange', () => this.applyFragment());
    this.stage.draw();
    this.stage.finish();
  }

  /** What the scene's <view> says of the hull. Without it the camera follows the vessel. */
  #takeView(view) {
    this.options.set('follow', !view);
    if (!view) return;
    this.options.set('hull', view.mesh === 'collision' ? 'collision' : 'fluid');
    this.options.set('wireframe', Boolean(view.wireframe));
    this.options.set('facenormals', Boolean(view.normals));
  }

  #buildPage() {
    const { facts, recording, options, player, live } = this, { head } = recording;
    const openHelp = () => byId('help').showModal();
    this.factsBar = new FactsBar(byId('facts'), facts.title, recording, options, openHelp);
    this.controls = new Controls(byId('controls'), player, recording, live, (text) => this.notices.show('control', text, true));
    this.panel = new Panel(byId('panel'), options, (option) => this.#isUseful(option, head));
    byId('panel').append(el('button', { type: 'button', style: 'margin-top: 14px; width: 100%', click: () => this.save() }, 'Save the picture'));
    const graphs = el('div'), bars = el('div', { class: 'bars' }, el('h3', {}, 'Time per step; the mark is the mean')), rows = el('div', { class: 'rows' });
    bars.append(rows);
    byId('dock').append(graphs, bars);
    this.graphBox = graphs;
    this.barBox = bars;
    this.graphs = new Graphs(graphs, recording, player);
    this.bars = new TimeBars(rows, recording);
    this.legend = new Legend(byId('legend'));
    this.card = new Card(byId('card'), () => this.pick(null));
    fillHelp(byId('help'), head.program ?? '', LICENCES);
    listenToKeys(player, options, { help: openHelp, save: () => this.save(), release: () => this.pick(null) });
    this.#listenToClicks();
  }

  #isUseful(option, head) {
    if (option.name === 'water') return head.water_level !== null && head.water_level !== undefined;
    if (option.name === 'timings') return head.channels.some((channel) => channel.group === 'time');
    if (option.name === 'graphs') return head.channels.length > 0;
    return true;
  }

  #afterShown() {
    const { frame } = this.world;
    this.factsBar.update(frame);
    if (this.options.get('timings')) this.bars.update(frame);
    this.legend.update(this.world, this.options);
    if (this.picked !== null) this.#showCard();
  }

  #applyOption(name) {
    const { options, world } = this;
    if (!world.frame) return;
    if (name === 'view') this.stage.camera.show(options.get('view'), this.recording.head.view, world.vesselPose());
    else if (name === 'follow') this.#setFollow();
    else if (name === 'color') {
      world.colours.mode = options.get('color');
      world.recolour();
    } else if (['graphs', 'timings', 'panel', 'ui'].includes(name)) this.#arrange();
    else world.applyOptions();
    this.legend?.update(world, options);
  }

  #setFollow() {
    const { camera } = this.stage, { place } = this.world.vesselPose();
    camera.follow(null);
    if (this.options.get('follow')) camera.follow(place);
  }

  #arrange() {
    const { options } = this;
    if (!this.graphBox) return;
    this.graphBox.hidden = !options.get('graphs') || this.recording.head.channels.length === 0;
    this.barBox.hidden = !options.get('timings');
    byId('dock').hidden = this.graphBox.hidden && this.barBox.hidden;
    byId('panel').hidden = !options.get('panel');
    document.body.classList.toggle('bare', !options.get('ui'));
    if (!this.graphBox.hidden) this.graphs.refresh();
    if (!this.barBox.hidden) this.bars.update(this.world.frame);
    this.stage.resize();
  }

  #listenToClicks() {
    const { canvas } = this.stage;
    let start = null;
    canvas.addEventListener('pointerdown', (event) => { start = event.isPrimary && event.button === 0 ? [event.clientX, event.clientY] : null; });
    canvas.addEventListener('pointerup', (event) => {
      if (start && Math.hypot(event.clientX - start[0], event.clientY - start[1]) < CLICK_PIXELS) this.pickAt(event.clientX, event.clientY);
      start = null;
    });
  }

  /** Picks what is drawn at a place on the screen. Returns its id, null for none. */
  pickAt(clientX, clientY) {
    const { world, options } = this, { frame } = world;
    const isShown = (kind) => {
      if (kind === BodyKind.wall) return false;
      return kind === BodyKind.floe || kind === BodyKind.rigid ? options.get('floes') : options.get('hull') !== 'none';
    };
    const b = pickBody(this.stage.rayAt(clientX, clientY), frame, world.poses, this.recording.shapes, isShown);
    this.pick(b < 0 ? null : frame.bodies.id[b]);
    return this.picked;
  }

  /** Picks a body by its id; null for none. Returns what is known of it. */
  async pick(id) {
    this.picked = id;
    this.world.pick(id);
    this.legend.update(this.world, this.options);
    if (id === null) {
      this.card.hide();
      return null;
    }
    return this.#showCard();
  }

  async #showCard() {
    const { frame } = this.world, { number } = this.player, id = this.picked;
    // A live run may drop the frame before meanwhile. Then the velocity is not known.
    const before = number > this.recording.first ? await this.store.get(number - 1).catch(() => null) : null;
    const body = describeBody(frame, before, id);
    if (this.picked === id && this.world.frame === frame) this.card.show(body, id);
    return body;
  }

  /** Does what the address' fragment says. Faults become a notice. */
  async applyFragment() { this.notices.show('fragment', (await this.applyWords(location.hash)).join(' ')); }

  /** Does what words such as `t=12.3&view=top` say. Returns what is wrong with them, a sentence each. */
  async applyWords(text) {
    const { options, words, unknown } = parseFragment(text), faults = unknown.map(unknownOption);
    for (const [name, value] of options) {
      try {
        this.options.set(name, value);
      } catch (error) {
        faults.push(error.message);
      }
    }
    if (words.speed) this.player.setSpeed(Number(words.speed) || 1);
    if (words.t !== undefined) await this.player.seek(Number(words.t));
    if (words.frame !== undefined) await this.player.seekFrame(this.recording.first + Number(words.frame));
    if (options.some(([name]) => name === 'view')) this.#applyOption('view');
    if (words.camera) this.#setCamera(words.camera.split(',').map(Number), faults);
    if (words.pick !== undefined) await this.pick(Number(words.pick));
    if (words.play === '1') this.player.play();
    return faults;
  }

  #setCamera(numbers, faults) {
    if (numbers.length !== 6 || !numbers.every(Number.isFinite)) {
      faults.push('The camera needs six numbers: its place and its target.');
      return;
    }
    this.stage.camera.camera.position.set(...numbers.slice(0, 3));
    this.stage.camera.controls.target.copy(new THREE.Vector3(...numbers.slice(3)));
    this.stage.camera.controls.update();
  }

  /** Saves the picture as a file. */
  save() {
    el('a', { href: this.stage.capture(), download: `${this.recording.head.scene || 'nilas'}-${this.player.time.toFixed(2)}s.png` }).click();
  }
}
