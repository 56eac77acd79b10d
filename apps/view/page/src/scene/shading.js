import * as THREE from 'three';

/** Shared parts of the shaders. Colours are sRGB values throughout; nothing is converted. */

/** Light from the sky and from a low sun, in the ground frame. */
export const LIGHT = /* glsl */`
vec3 lit(vec3 base, vec3 n) {
  const vec3 sun = vec3(-0.45, -0.35, 0.82);
  float sky = 0.5 + 0.5 * n.z;
  vec3 ambient = mix(vec3(0.50, 0.56, 0.64), vec3(0.70, 0.72, 0.74), sky);
  return base * (ambient + 0.34 * max(dot(n, sun), 0.0));
}
/// The normal of the face at a fragment, towards the camera. v: its place from the camera.
vec3 face_normal(vec3 v) {
  vec3 n = cross(dFdx(v), dFdy(v));
  float size = length(n);
  return size > 0.0 ? n / size : vec3(0.0, 0.0, 1.0);
}
`;

/** Turns a vector by a unit quaternion (x, y, z, w). */
export const TURN = /* glsl */`
vec3 turned(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }
`;

/**
 * Edges are drawn on their faces: a little nearer to the camera, on the same ray. An offset of the faces' depth would sink
 * thin floes below the water where they are seen at a low angle.
 */
export const EDGES_NEARER = 0.999;

/** A material for lines that lie on faces. */
export function edgeMaterial(colour, opacity) {
  return new THREE.ShaderMaterial({ transparent: true, depthWrite: false,
    uniforms: { colour: { value: new THREE.Color(colour) }, opacity: { value: opacity } },
    vertexShader: `void main() {
  vec3 view = (modelViewMatrix * vec4(position, 1.0)).xyz;
  gl_Position = projectionMatrix * vec4(${EDGES_NEARER} * view, 1.0);
}`,
    fragmentShader: 'uniform vec3 colour; uniform float opacity; void main() { gl_FragColor = vec4(colour, opacity); }' });
}

/** Colours of things, as 0xrrggbb. */
export const COLOURS = {
  background: 0xe8eef3, ice: 0xf7fafc, iceEdge: 0x3c5a6e, water: 0x3f7ea6, rigid: 0xc9a66b, wall: 0x8a949c,
  hull: 0x33475b, hullBelow: 0xa5473a, hullEdge: 0x1c2935, part: 0x5b7286, tank: 0x6c7a86, picked: 0xff9d2e,
  open: 0x9aa5ad, stick: 0x0f8f8c, slip: 0xe0a100, crush: 0xd62839, normal: 0x5d4a9c, forceOnVessel: 0xd62839,
  forceOnFloe: 0x7a3db8, mooring: 0x2d3e4e, rod: 0x6b4f2a, thruster: 0x1d7f45, carriage: 0x0b63b5, wind: 0x4d8fb8,
  path: 0xb0307a,
};

/** The components of 0xrrggbb, 0 to 255. */
export function bytesOfColour(colour) { return [colour >> 16, (colour >> 8) & 255, colour & 255]; }
