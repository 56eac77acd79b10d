#!/usr/bin/env python3
"""Holds a vessel at a place and a heading through <vessel><remote_control force="true">.

Usage: controller.py SOCKET X Y HEADING_DEG. It needs nothing but Python's standard library.
"""
import json
import math
import socket
import sys
import time

MASS = 1500.0  # of the vessel [kg]
PERIOD = 6.0  # wanted period of its motion about the set-point [s]
DAMPING = 0.7  # share of critical damping
RADIUS = 1.5  # radius of gyration in yaw [m]


def connect(path, seconds):
    """Connects to the run's socket, which appears when its first step begins."""
    end = time.monotonic() + seconds
    while True:
        try:
            client = socket.socket(socket.AF_UNIX)
            client.connect(path)
            return client
        except (FileNotFoundError, ConnectionRefusedError):
            client.close()
            if time.monotonic() > end:
                raise
            time.sleep(0.05)


def commands(state, place, heading):
    """A proportional-derivative law, in the axes of the vessel."""
    omega = 2 * math.pi / PERIOD
    k, c = omega**2, 2 * DAMPING * omega
    yaw = state["yaw_rad"]
    dx, dy = place[0] - state["position_m"][0], place[1] - state["position_m"][1]
    ahead = math.cos(yaw) * dx + math.sin(yaw) * dy
    to_port = -math.sin(yaw) * dx + math.cos(yaw) * dy
    turn = math.remainder(heading - yaw, 2 * math.pi)
    surge, sway, _ = state["speeds_m_s"]
    rate = state["rates_rad_s"][2]
    return {
        "force_x": MASS * (k * ahead - c * surge),
        "force_y": MASS * (k * to_port - c * sway),
        "moment_z": MASS * RADIUS**2 * (k * turn - c * rate),
    }


def main():
    path, place = sys.argv[1], (float(sys.argv[2]), float(sys.argv[3]))
    heading = math.radians(float(sys.argv[4]))
    lines = connect(path, 30).makefile("rw", encoding="utf-8", newline="\n")
    for line in lines:
        answer = {"commands": commands(json.loads(line), place, heading)}
        lines.write(json.dumps(answer) + "\n")
        lines.flush()


if __name__ == "__main__":
    main()
