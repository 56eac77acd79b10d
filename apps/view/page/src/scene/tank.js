import * as THREE from 'three';
import { COLOURS } from './shading.js';

/** The outline of the tank: its floor, walls as lines, and marks along the rim. */
export class Tank {
  object = new THREE.Group();

  setScene(head) {
    this.object.clear();
    const { tank } = head;
    if (!tank) return;
    const level = head.water_level ?? 0, depth = tank.depth || 0.1 * tank.width;
    const bottom = level - depth, top = level + 0.06 * tank.width, half = tank.width / 2;
    const corner = (k, z) => new THREE.Vector3(k & 1 ? tank.length : 0, k & 2 ? half : -half, z);
    const lines = [];
    for (const z of [bottom, top]) for (const [a, b] of [[0, 1], [1, 3], [3, 2], [2, 0]]) lines.push(corner(a, z), corner(b, z));
    for (let k = 0; k < 4; ++k) lines.push(corner(k, bottom), corner(k, top));
    this.object.add(new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(lines),
                                           new THREE.LineBasicMaterial({ color: COLOURS.tank })));
    const floor = new THREE.Mesh(new THREE.PlaneGeometry(tank.length, tank.width),
                                 new THREE.MeshBasicMaterial({ color: 0xc6d3dc, side: THREE.DoubleSide }));
    floor.position.set(tank.length / 2, 0, bottom);
    this.object.add(floor);
  }
}
