import * as THREE from 'three';

const FIRST_CAPACITY = 64;

/** Many things of one kind in one draw call. Each has a row of numbers; the buffers grow as rows are added. */
export class Layer {
  #columns;
  #capacity = 0;
  /** The number of rows. */
  count = 0;
  /** By the names of the columns: typed arrays that hold all rows. */
  values = {};

  /**
   * @param {THREE.Mesh|THREE.Points} object whose geometry has what all things share
   * @param {Record<string, {Type: Function, size: number}>} columns bytes count as shares of 255
   * @param {number} order in which it is drawn
   */
  constructor(object, columns, order) {
    this.object = object;
    this.#columns = columns;
    object.frustumCulled = false;
    object.renderOrder = order;
    this.#grow(FIRST_CAPACITY);
  }

  /** Whether bodies in front hide it. */
  set isHidden(value) {
    this.object.material.depthTest = value;
    this.object.material.transparent = !value;
  }

  clear() { this.count = 0; }

  /** Adds a row, to be filled in `values`. Returns its number. */
  addRow() {
    if (this.count === this.#capacity) this.#grow(2 * this.#capacity);
    return this.count++;
  }

  /** To be called after the last row was filled. */
  done() {
    const { geometry } = this.object;
    if (geometry.isInstancedBufferGeometry) geometry.instanceCount = this.count;
    else geometry.setDrawRange(0, this.count);
    for (const name of Object.keys(this.#columns)) {
      const attribute = geometry.attributes[name];
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, attribute.itemSize * this.count);
      attribute.needsUpdate = true;
    }
  }

  /** Buffers cannot change their size, so a new geometry takes over what is shared. */
  #grow(capacity) {
    const old = this.object.geometry, geometry = new old.constructor(), isInstanced = old.isInstancedBufferGeometry;
    const Attribute = isInstanced ? THREE.InstancedBufferAttribute : THREE.BufferAttribute;
    if (old.index) geometry.setIndex(old.index);
    for (const [name, attribute] of Object.entries(old.attributes)) if (!(name in this.#columns)) geometry.setAttribute(name, attribute);
    for (const [name, { Type, size }] of Object.entries(this.#columns)) {
      const values = new Type(size * capacity);
      if (this.values[name]) values.set(this.values[name]);
      this.values[name] = values;
      geometry.setAttribute(name, new Attribute(values, size, Type === Uint8Array));
    }
    this.#capacity = capacity;
    this.object.geometry = geometry;
    old.dispose();
  }
}

/** Adds attributes to a geometry, from lists of numbers that belong to its corners: {position: [list, 3]}. */
export function withAttributes(geometry, lists) {
  for (const [name, [list, size]] of Object.entries(lists)) geometry.setAttribute(name, new THREE.Float32BufferAttribute(list, size));
  return geometry;
}
