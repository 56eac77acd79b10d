import * as THREE from 'three';
import { Camera } from './camera.js';
import { COLOURS } from './shading.js';

THREE.ColorManagement.enabled = false;

/** The canvas, the renderer and the camera. A picture is drawn only when something has changed. */
export class Stage {
  scene = new THREE.Scene();
  /** Called before each picture. */
  beforePicture = () => {};
  #needed = false;
  #times = [];

  /** @param {HTMLElement} box that the canvas fills */
  constructor(box) {
    this.box = box;
    this.renderer = new THREE.WebGLRenderer({ antialias: true, powerPreference: 'high-performance' });
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    this.renderer.setClearColor(COLOURS.background);
    this.canvas = this.renderer.domElement;
    box.append(this.canvas);
    this.camera = new Camera(this.canvas, () => this.invalidate());
    new ResizeObserver(() => this.resize()).observe(box);
    this.resize();
  }

  resize() {
    const width = Math.max(this.box.clientWidth, 1), height = Math.max(this.box.clientHeight, 1);
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height);
    this.camera.resize(width, height);
    this.invalidate();
  }

  /** The size of a pixel at unit distance. */
  get pixel() {
    return 2 * Math.tan(this.camera.camera.fov * Math.PI / 360) / Math.max(this.box.clientHeight, 1);
  }

  invalidate() {
    if (this.#needed) return;
    this.#needed = true;
    requestAnimationFrame(() => {
      if (this.#needed) this.draw();
    });
  }

  /** Draws at once. */
  draw() {
    this.#needed = false;
    this.camera.fit();
    this.beforePicture();
    this.renderer.render(this.scene, this.camera.camera);
    this.#times.push(performance.now());
    if (this.#times.length > 60) this.#times.shift();
  }

  /** Pictures a second over the last ones, 0 while the page rests. */
  get picturesPerSecond() {
    const times = this.#times, now = performance.now(), recent = times.filter((t) => now - t < 2000);
    return recent.length < 2 ? 0 : 1000 * (recent.length - 1) / (recent[recent.length - 1] - recent[0]);
  }

  /** Waits until the graphics have finished what was asked of them. */
  finish() {
    const gl = this.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  /** The picture as a PNG data URL. */
  capture() {
    this.draw();
    return this.canvas.toDataURL('image/png');
  }

  /** The ray through a place on the screen. */
  rayAt(clientX, clientY) {
    const box = this.canvas.getBoundingClientRect();
    const place = new THREE.Vector2(2 * (clientX - box.left) / box.width - 1, 1 - 2 * (clientY - box.top) / box.height);
    // The camera may have moved since the last picture.
    this.camera.fit();
    const caster = new THREE.Raycaster();
    caster.setFromCamera(place, this.camera.camera);
    return caster.ray;
  }
}
