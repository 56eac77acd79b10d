#!/usr/bin/env python3
"""The packed scene on MuJoCo in its honest setting: Newton to convergence on elliptic cones, the stiffest reference
that it allows at this step. Prints one row as the other peers do, of what is measured in SECONDS of CPU time (300).
usage: mujoco_peer.py SCENE [SECONDS]"""
import math
import sys
import time

import mujoco as mj
import numpy as np

DENSITY, WATER, GRAVITY, FRICTION, STEP, DRAG = 920, 1005, 9.81, 0.15, 0.01, 0.2  # as in floe_scene.h
FIRST_MEASURED, LAST_MEASURED, FEWEST_MEASURED = 140, 240, 10
HULL_ARMATURE = 1e7  # [kg] a body of prescribed speed is one that no contact can slow; set anew each step
TOLERANCE = 1e-16  # of MuJoCo's scaled cost, which the armature loosens: leaves M v - f - H r below 1e-6 m/s
ARENA_PER_FLOE = 1 << 19  # [bytes]


class Floe:
    """An outline about its centroid and along its principal axes, mass properties and buoyancy columns."""

    def __init__(self, outline, thickness):
        nxt = np.roll(outline, -1, axis=0)
        c = cross(outline, nxt)
        area = c.sum() / 2
        self.centre = ((outline + nxt) * c[:, None]).sum(0) / (6 * area)
        a = outline - self.centre
        b = np.roll(a, -1, axis=0)
        c = cross(a, b)
        xx, yy = (c[:, None] * (a * a + a * b + b * b)).sum(0) / 12
        xy = (c * (a[:, 0] * b[:, 1] + 2 * a.prod(1) + 2 * b.prod(1) + b[:, 0] * a[:, 1])).sum() / 24
        self.yaw = 0.5 * math.atan2(2 * xy, xx - yy)
        cs, sn = math.cos(self.yaw), math.sin(self.yaw)
        self.outline = a @ np.array([[cs, -sn], [sn, cs]])
        pxx = cs * cs * xx + 2 * cs * sn * xy + sn * sn * yy
        pyy = xx + yy - pxx
        sheet, plate = DENSITY * thickness, area * thickness**2 / 12
        self.mass = sheet * area
        self.inertia = np.array([sheet * (pyy + plate), sheet * (pxx + plate), sheet * (pxx + pyy)])
        nxt = np.roll(self.outline, -1, axis=0)
        self.column = (self.outline + nxt) / 3
        self.column_area = cross(self.outline, nxt) / 2


def cross(a, b):
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]


class Scene:
    def __init__(self, path):
        with open(path, encoding="ascii") as file:
            numbers = iter([float(word) for word in file.read().split()])
        self.thickness, *self.walls, self.current = (next(numbers) for _ in range(6))
        self.hull_x, length, bow, beam, *self.hull_z, self.hull_speed = (next(numbers) for _ in range(7))
        s, b = length - bow, 0.5 * beam
        self.hull_outline = np.array([[0, -b], [s, -b], [length, 0], [s, b], [0, b]])
        self.floes = []
        for _ in range(int(next(numbers))):
            outline = np.array([next(numbers) for _ in range(2 * int(next(numbers)))]).reshape(-1, 2)
            self.floes.append(Floe(outline, self.thickness))
        self.mass = np.array([f.mass for f in self.floes])
        self.inertia = np.array([f.inertia for f in self.floes])
        most = max(len(f.column) for f in self.floes)
        self.column, self.column_area = np.zeros((len(self.floes), most, 2)), np.zeros((len(self.floes), most))
        for k, f in enumerate(self.floes):
            self.column[k, : len(f.column)], self.column_area[k, : len(f.column)] = f.column, f.column_area

    def mass_diagonal(self):
        """Masses of MuJoCo's velocities: per floe linear in G, angular in its own axes; last the hull's speed."""
        return np.append(np.hstack([np.repeat(self.mass[:, None], 3, axis=1), self.inertia]), HULL_ARMATURE)


def add_prism(spec, body, name, outline, bottom, top):
    corners = [[x, y, z] for z in (bottom, top) for x, y in outline]
    spec.add_mesh(name=name, uservert=np.array(corners).ravel())
    touchable(body.add_geom(type=mj.mjtGeom.mjGEOM_MESH, meshname=name))


def add_body(spec, mass, inertia, **pose):
    return spec.worldbody.add_body(mass=mass, inertia=inertia, ipos=[0, 0, 0], explicitinertial=True, **pose)


def touchable(geom):
    geom.condim, geom.friction, geom.solref = 3, [FRICTION, 0, 0], [2 * STEP, 1]


def build(s):
    spec = mj.MjSpec()
    option = spec.option
    option.timestep, option.gravity = STEP, [0, 0, -GRAVITY]
    option.solver, option.cone, option.jacobian = mj.mjtSolver.mjSOL_NEWTON, mj.mjtCone.mjCONE_ELLIPTIC, 1  # sparse
    option.iterations, option.tolerance, option.impratio = 100, TOLERANCE, 10
    if hasattr(mj.mjtEnableBit, "mjENBL_MULTICCD"):  # newer ones find the corners of touching faces unasked
        option.enableflags |= mj.mjtEnableBit.mjENBL_MULTICCD
    spec.memory = ARENA_PER_FLOE * max(100, len(s.floes))
    x0, x1, y0, y1 = s.walls
    for x, y, nx, ny in ((x0, 0, 1, 0), (x1, 0, -1, 0), (0, y0, 0, 1), (0, y1, 0, -1)):
        pose = {"pos": [x, y, 0], "quat": [1, -ny, nx, 0]}
        touchable(spec.worldbody.add_geom(type=mj.mjtGeom.mjGEOM_PLANE, size=[0, 0, 1], **pose))
    mid_plane = s.thickness * (0.5 - DENSITY / WATER)
    for k, f in enumerate(s.floes):
        turn = [math.cos(f.yaw / 2), 0, 0, math.sin(f.yaw / 2)]
        body = add_body(spec, f.mass, f.inertia, pos=[*f.centre, mid_plane], quat=turn)
        body.add_freejoint()
        add_prism(spec, body, f"floe{k}", f.outline, -s.thickness / 2, s.thickness / 2)
    hull = add_body(spec, 1, [1, 1, 1])
    hull.add_joint(type=mj.mjtJoint.mjJNT_SLIDE, axis=[1, 0, 0], armature=HULL_ARMATURE)
    add_prism(spec, hull, "hull", s.hull_outline, *s.hull_z)
    return spec.compile()


def water_load(s, qpos, qvel):
    """Buoyancy and heave damping on columns, linear drag towards the current: force in G, moment in body axes."""
    w, x, y, z = qpos[:, 3:].T
    R = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                  [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                  [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
    H, omega = s.thickness, math.sqrt(WATER * GRAVITY / (DENSITY * s.thickness))
    spin = np.einsum("ijn,nj->ni", R, qvel[:, 3:])
    rx, ry, rz = np.einsum("ijn,nkj->ink", R[:, :2], s.column)
    wet = np.clip(H / 2 - (qpos[:, 2, None] + rz), 0, H)
    heave = qvel[:, 2, None] + spin[:, 0, None] * ry - spin[:, 1, None] * rx
    fz = s.column_area * (WATER * GRAVITY * wet - (wet > 0) * (DENSITY * H * omega * heave))
    moment = np.stack([(ry * fz).sum(1), -(rx * fz).sum(1), -s.inertia[:, 2] * DRAG * spin[:, 2]])
    load = np.zeros_like(qvel)
    load[:, :2] = -DRAG * s.mass[:, None] * (qvel[:, :2] - [s.current, 0])
    load[:, 2] = fz.sum(1)
    load[:, 3:] = np.einsum("ijn,in->nj", R, moment)
    return load


def project_cone(x, mu):
    n, t = x[:, 0], np.hypot(x[:, 1], x[:, 2])
    height = np.maximum(0, (n + mu * t) / (1 + mu * mu))
    side = mu * height / np.maximum(t, 1e-300)
    nearest = np.stack([height, side * x[:, 1], side * x[:, 2]], axis=1)
    return np.where((t <= mu * n)[:, None], x, nearest)


def natural_map(data, mass_diagonal):
    """As yardstick.h: largest distance from exact Coulomb [m/s] at the speed of separation that MuJoCo's reference asks
    for. Its softness and its creep of sticking contacts count as errors, since exact contact has neither."""
    if data.nefc == 0:
        return 0.0
    column, first = data.efc_J_colind, data.efc_J_rowadr
    u = np.add.reduceat(data.efc_J * data.qvel[column], first).reshape(-1, 3)
    d = np.add.reduceat(data.efc_J**2 / mass_diagonal[column], first).reshape(-1, 3).sum(1)[:, None] / 3
    u[:, 0] -= (data.efc_vel + STEP * data.efc_aref)[::3]
    r = STEP * data.efc_force.reshape(-1, 3)
    u[:, 0] += FRICTION * np.hypot(u[:, 1], u[:, 2])
    return float(np.linalg.norm(d * (r - project_cone(r - u / d, FRICTION)), axis=1).max())


def now_ms():
    return 1e3 * time.thread_time()


def main(path, seconds=300):
    s = Scene(path)
    count, model = len(s.floes), build(s)
    data = mj.MjData(model)
    mass_diagonal = s.mass_diagonal()
    mj.set_mjcb_time(now_ms)
    warnings = []  # after one MuJoCo starts anew or drops contacts, and goes on
    mj.set_mju_user_warning(warnings.append)
    collision = data.timer[mj.mjtTimer.mjTIMER_POS_COLLISION]
    window, contacts, penetration = [], 0, 0.0
    for n in range(LAST_MEASURED):
        detect = collision.duration
        t0 = now_ms()
        qpos, qvel = data.qpos[:-1].reshape(count, 7), data.qvel[:-1].reshape(count, 6)
        data.qfrc_applied[:-1] = water_load(s, qpos, qvel).ravel()
        data.qpos[-1], data.qvel[-1] = s.hull_x + s.hull_speed * n * STEP, s.hull_speed
        t1 = now_ms()
        mj.mj_step(model, data)
        t2 = now_ms()
        if warnings:
            sys.exit(f"mujoco on {count} floes: step {n}: {warnings[0]}")
        if n >= FIRST_MEASURED:
            detect = collision.duration - detect
            window.append([detect, t2 - t1 - detect, t1 - t0, t2 - t0, natural_map(data, mass_diagonal)])
            contacts += data.ncon
            penetration = max(penetration, -data.contact.dist.min(initial=0))
        if t2 > 1e3 * seconds:
            print(f"mujoco on {count} floes: {n + 1} of {LAST_MEASURED} steps within {seconds:g} s", file=sys.stderr)
            break
    if len(window) < FEWEST_MEASURED:
        sys.exit(1)
    columns = np.sort(np.array(window), axis=0)
    detect, solve, water, total, natural = columns[len(window) // 2]
    total_95 = columns[len(window) * 95 // 100, 3]
    print(f"mujoco,{count},0,{detect:.4f},{solve:.4f},{water:.4f},{total:.4f},{contacts / len(window):.1f},"
          f"{penetration / s.thickness:.4f},{total_95:.4f},{natural:.3g},0")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(sys.argv[1], *map(float, sys.argv[2:]))
