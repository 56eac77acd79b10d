#!/usr/bin/python3 -S
"""Stands in for the program where tests need runs of a chosen length that fail, hang or stop.

It keeps to what the study relies on: options, exit codes, the files of a run folder, and the
checkpoint after a signal. The load is 10 x + 3 y^2 plus noise that follows from the seed. The
tests in test_program.py hold the study against the real program.

Only a whole run has the object load_error.

Attributes: test/@x, test/@y; test/@steps of 20 ms each; test/@fail = code at half of the steps,
test/@die = true ends it by SIGKILL; x = 99 is refused by check and run.
"""

import json
import os
import random
import signal
import sys
import time

stopped = []


def main(words):
    if words == ["--version"]:
        print("nilas 9.9.9 (stand-in)")
        return 0
    command, options = words[0], parse(words[1:])
    if command == "check":
        return refused(dict(pair.split("=", 1) for pair in options.get("--set", [])))
    folder = options["--resume"][0] if "--resume" in options else options["--out"][0]
    return run(folder, options)


def parse(words):
    options, name = {}, "scene"
    for word in words:
        if word.startswith("--"):
            name = word
            options[name] = []
        else:
            options.setdefault(name, []).append(word)
    return options


def refused(settings):
    if settings.get("test/@x") == "99":
        print("scene.xml:1: <test x>: error: 99 is too large", file=sys.stderr)
        return 2
    for path in settings:
        if path not in ("test/@x", "test/@y", "test/@steps", "test/@fail", "test/@die"):
            print(f"--set {path}: error: there is no such element", file=sys.stderr)
            return 2
    return 0


def run(folder, options):
    signal.signal(signal.SIGINT, lambda *_: stopped.append(1))
    signal.signal(signal.SIGTERM, lambda *_: stopped.append(1))
    os.makedirs(folder, exist_ok=True)
    checkpoint = os.path.join(folder, "checkpoint.h5")
    if "--resume" in options:
        with open(checkpoint) as file:
            state = json.load(file)
        state["sessions"] += 1
    else:
        settings = dict(pair.split("=", 1) for pair in options.get("--set", []))
        seed = int(options.get("--seed", ["1"])[0])
        state = {"settings": settings, "seed": seed, "step": 0, "sessions": 1}
        if "--until" in options:  # the study asks for one step alone
            settings["test/@steps"] = "1"
    if refused(state["settings"]):
        return 2
    return work(folder, checkpoint, state, "--checkpoint-every" in options)


def steps_of(settings):
    return int(settings.get("test/@steps", "1"))


def work(folder, checkpoint, state, stores):
    settings = state["settings"]
    steps = steps_of(settings)
    while state["step"] < steps:
        time.sleep(0.02)
        state["step"] += 1
        if stores or stopped:
            with open(checkpoint, "w") as file:
                json.dump(state, file)
        if stopped:
            return 130
        if "test/@fail" in settings and 2 * state["step"] >= steps:
            print(f"error: {folder}: the ice left finite numbers", file=sys.stderr)
            return int(settings["test/@fail"])
        if settings.get("test/@die") == "true":
            os.kill(os.getpid(), signal.SIGKILL)
    finish(folder, state)
    return 0


def finish(folder, state):
    settings = state["settings"]
    x, y = float(settings.get("test/@x", "1")), float(settings.get("test/@y", "1"))
    load = 10 * x + 3 * y**2 + random.Random(f"{x} {y} {state['seed']}").gauss(0, 1)
    summary = {
        "status": "done", "vessel": {"mass_kg": 9.0}, "exit_code": 0, "wall_s": 0.02 * state["step"], "processor_s": 0.01,
        "ice_load": {"along": {"mean_N": load, "std_N": None}}, "sessions": state["sessions"],
        "versions": {"nilas": "9.9.9"},
    }  # fmt: skip
    if steps_of(settings) > 1:
        summary["load_error"] = {"mean_N": load, "chaos_N": None}
    files = {
        "scene.xml": json.dumps(settings),
        "summary.json": json.dumps(summary),
        "vessel.csv": "time_s,contact_fx_N\n0.1,1\n0.2,3\n0.3,-8\n",
        "nilas.log": "log\n",
    }
    for name, text in files.items():
        with open(os.path.join(folder, name), "w") as file:
            file.write(text)


sys.exit(main(sys.argv[1:]))
