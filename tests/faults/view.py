#!/usr/bin/env python3
"""Attacks the live view of a run, and judges the answers, the run and what it costs.

usage: view.py PROGRAM [--quick] [--csv FILE]

A run without a live view gives the bits to compare with. A second run shows itself, and while it goes on it gets
requests that are wrong or hostile, clients that are slow, that leave, and many at once. Each line of the table is one
attack: how many attempts, what was answered, and whether that is allowed. The run must end by itself with the same
bits, few open files and little memory, and its port must be closed then. --quick is the form of the tests.
"""
import argparse
import collections
import csv
import hashlib
import os
import pathlib
import re
import resource
import socket
import subprocess
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
COLUMNS = ("attack", "attempts", "answers", "allowed", "good")
MOST_FILES = 64 + 40  # [1] the connections of the server, and what a run has open
MOST_GROWTH = 64  # [MB] above a run without a live view
MOST_TIME = 1.2  # [1] of the time that the pace of the clock gives the run
LONGEST_END = 10  # [s] from the end of the run to that of the program
END = 60  # [s], of the run
QUICK_PACE = 15  # simulated over real time
HEADERS = ("content-security-policy", "x-content-type-options", "referrer-policy", "cache-control")

SCENE = """<scene version="1">
  <time step="0.01" end="{end}"/>
  <contact law="coulomb" solver="nsgs" tolerance="1e-6"/>
  <body name="ground" shape="plane" fixed="true"/>
  <body name="box" shape="box" size="1 1 1" mass="2" position="0 0 0.5" velocity="1 0 0"/>
  <body name="above" shape="box" size="1 1 1" mass="2" position="0.2 0 1.5"/>
  <output contacts="all" trajectory_every="0.5" checkpoint_every="5"/>
</scene>
"""


class Run:
    """A run, and its address where it has a live view."""

    def __init__(self, program, folder, name, view):
        self.folder = folder / name
        self.said = open(folder / f"{name}.txt", "w+", encoding="utf-8")
        words = [program, "run", "s.xml", "--out", name, "--quiet", *(["--view"] if view else [])]
        self.process = subprocess.Popen(words, cwd=folder, stdout=subprocess.DEVNULL, stderr=self.said,
                                        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (256, 256)))
        self.most_files, self.port, self.token = 0, None, None
        while view and self.process.poll() is None and self.port is None:
            time.sleep(0.01)
            found = re.search(r"http://127\.0\.0\.1:(\d+)/\?token=([0-9a-f]{32})\n", pathlib.Path(self.said.name).read_text())
            if found:
                self.port, self.token = int(found[1]), found[2]

    def look(self):
        """Notes the number of open files."""
        try:
            self.most_files = max(self.most_files, len(os.listdir(f"/proc/{self.process.pid}/fd")))
        except OSError:
            pass

    def end(self):
        _, status, used = os.wait4(self.process.pid, 0)
        self.process.returncode = os.waitstatus_to_exitcode(status)
        self.seconds, self.memory = used.ru_utime + used.ru_stime, used.ru_maxrss / 1024
        return self.process.returncode

    def bits(self):
        """A hash of what the run computed: motions, and bodies and forces of the frames. Other files hold times too."""
        digest = hashlib.sha256()
        for file in sorted([self.folder / "bodies.csv", *self.folder.glob("trajectory/*")]):
            digest.update(file.name.encode() + file.read_bytes())
        return digest.hexdigest()


def connect(run, timeout=10):
    return socket.create_connection(("127.0.0.1", run.port), timeout=timeout)


def answer(run, request, timeout=10, most=1 << 16):
    """The status of the answer to these bytes, "closed" or "silent", and the answer."""
    try:
        with connect(run, timeout) as client:
            try:
                client.sendall(request)
            except OSError:
                pass  # the server may have answered and closed before it had all
            data = b""
            while len(data) < most and (part := client.recv(4096)):
                data += part
                if b"\r\n\r\n" in data and data.startswith(b"HTTP/1.1 200") and b"/events" in request:
                    break
    except TimeoutError:
        return "silent", b""
    except OSError:
        return "closed", b""
    found = re.match(rb"HTTP/1\.[01] (\d{3})", data)
    return (found[1].decode() if found else "closed"), data


def request(run, path="/", method="GET", token=True, host=None, headers=(), body=b""):
    host = host if host is not None else f"127.0.0.1:{run.port}"
    query = f"?token={run.token if token is True else token}" if token is not None else ""
    lines = [f"{method} {path}{query} HTTP/1.1", f"Host: {host}", "Connection: close", *headers]
    if body:
        lines.append(f"Content-Length: {len(body)}")
    return ("\r\n".join(lines) + "\r\n\r\n").encode("latin-1") + body


ATTACKS = {}


def attack(allowed):
    """An attack by single requests, and the answers that are allowed."""
    def note(function):
        ATTACKS[function.__name__.replace("_", " ")] = (function, allowed)
        return function
    return note


@attack({"200"})
def whole_address(run):
    yield request(run)
    yield request(run, host=f"localhost:{run.port}")
    yield request(run, headers=[f"Origin: http://127.0.0.1:{run.port}"])


@attack({"403"})
def missing_or_wrong_token(run):
    for token in (None, "", "0" * 32, run.token[:-1], run.token + "0", run.token.upper() + "x", "%00", run.token[:16],
                  "*", "' OR 1=1", "../" + run.token):
        for path, method in (("/", "GET"), ("/events", "GET"), ("/control", "POST")):
            yield request(run, path, method, token=None if token is None else token.replace(" ", "+"))
    yield request(run, token=None, headers=[f"Cookie: token={run.token}", f"Authorization: Bearer {run.token}"])


@attack({"403", "400"})
def other_host_name(run):
    for host in ("evil.example", f"evil.example:{run.port}", "127.0.0.1.evil.example", f"localhost.evil.example:{run.port}",
                 "127.0.0.1@evil.example", "0.0.0.0", "[::]", "127.1", "2130706433", "", "localhost:x:y", "LOCALHOST.",
                 "127.0.0.1, evil.example", "\t"):
        yield request(run, host=host)
    yield f"GET /?token={run.token} HTTP/1.0\r\n\r\n".encode()


@attack({"403"})
def other_origin(run):
    for origin in ("http://evil.example", "null", f"http://localhost.evil.example:{run.port}", f"https://127.0.0.1:{run.port}",
                   "http://127.0.0.1:1", "file://"):
        yield request(run, "/control", "POST", headers=[f"Origin: {origin}"], body=b'{"action":"pause"}')
        yield request(run, "/events", headers=[f"Origin: {origin}"])


@attack({"400", "403", "404", "closed"})
def path_traversal(run):
    for path in ("/../../../../etc/passwd", "/..%2f..%2f..%2fetc/passwd", "/%2e%2e/%2e%2e/etc/passwd",
                 "/%252e%252e%252fetc/passwd", "/..\\..\\etc\\passwd", "/..%5c..%5cetc%5cpasswd", "//etc/passwd",
                 "/events/../../s.xml", "/%00", "/events%00.html", "/\x00", "/.", "/./../s.xml", "/%c0%ae%c0%ae/s.xml",
                 "/nilas.log", "/checkpoint.h5", "/%", "/%zz", "/" + "../" * 500):
        yield request(run, path)
        yield request(run, path, token=None)


@attack({"400", "403", "404", "405", "closed"})
def other_methods(run):
    for method in ("PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "CONNECT", "PRI", "get", "POST", "X" * 5000, "", "\x00"):
        yield request(run, "/", method)
    yield request(run, "/control", "GET")
    yield request(run, "/events", "POST", body=b"x")


@attack({"400", "403", "404", "413", "414", "431", "closed"})
def oversized(run):
    yield request(run, "/" + "a" * 100000)
    yield request(run, token="a" * 100000)
    yield request(run, headers=["X: " + "a" * 100000])
    yield request(run, "/control", "POST", body=b"a" * 5000)
    yield request(run, "/control", "POST", body=b"a" * 10000000)
    yield request(run, "/control", "POST", headers=["Content-Length: 99999999999999999999"])
    yield request(run, "/control", "POST", headers=["Content-Length: -1"])
    yield request(run, "/control", "POST", headers=["Transfer-Encoding: chunked"]) + b"fffffff\r\n" + b"a" * 100000
    yield b"\x00" * 100000
    yield bytes(range(256)) * 400


@attack({"400"})
def wrong_control(run):
    for body in (b"{", b"[]", b"null", b'{"action":"stop"}', b'{"action":"slow","factor":-1}', b'{"action":"slow"}',
                 b'{"action":"slow","factor":1e999}', b"[" * 4000, b"\xff\xfe", b'{"action":1}',
                 b'{"action":"slow","factor":"x"}'):
        yield request(run, "/control", "POST", body=body)


def judged(name, answers, allowed, good=None):
    told = ", ".join(f"{key}: {count}" for key, count in sorted(answers.items()))
    good = all(key in allowed for key in answers) if good is None else good
    row = {"attack": name, "attempts": sum(answers.values()), "answers": told,
           "allowed": " ".join(sorted(allowed)), "good": "yes" if good else "no"}
    print(", ".join(f"{key}: {value}" for key, value in row.items()), flush=True)
    return row


def single_requests(run):
    for name, (function, allowed) in ATTACKS.items():
        answers, bare = collections.Counter(), 0
        for each in function(run):
            code, data = answer(run, each)
            answers[code] += 1
            head = data.split(b"\r\n\r\n")[0].decode("latin-1").lower()
            # The library answers what is no request before anything of the program is asked.
            bare += code in ("200", "204", "403", "404") and not all(header in head for header in HEADERS)
            if b"root:" in data:
                answers["a file of the system"] += 1
            run.look()
        if bare:
            answers["headers of security missing"] = bare
        yield judged(name, answers, allowed)


class Crowd:
    """Clients that misbehave for as long as the run goes on, each kind in a thread of its own."""

    def __init__(self, run, quick):
        self.run, self.over, self.clients, self.counts = run, threading.Event(), [], collections.Counter()
        kinds = [(self.slow, 40), (self.half_open, 40), (self.never_reads, 20), (self.leaves, 1), (self.asks, 1),
                 (self.many, 30 if quick else 1000)]
        self.threads = [threading.Thread(target=kind, args=(count,)) for kind, count in kinds]
        for thread in self.threads:
            thread.start()

    def open(self, kind, count):
        clients = []
        for _ in range(count):
            try:
                clients.append(connect(self.run, 2))
                self.counts[kind] += 1
            except OSError:
                self.counts[kind + ", refused"] += 1
            if self.over.is_set():
                break
        return clients

    def slow(self, count):
        clients, text, at = self.open("one byte a second", count), request(self.run), 0
        while clients and not self.over.wait(1):
            for client in list(clients):
                try:
                    client.send(text[at:at + 1])
                except OSError:
                    clients.remove(client)
                    self.counts["one byte a second, ended by the server"] += 1
            at = (at + 1) % (len(text) - 1)

    def half_open(self, count):
        clients = self.open("sends nothing", count)
        self.over.wait()
        del clients

    def never_reads(self, count):
        clients = self.open("reads no answer", count)
        for client in clients:
            try:
                client.sendall(request(self.run, "/events"))
            except OSError:
                pass
        self.over.wait()

    def leaves(self, _):
        while not self.over.wait(0.05):
            try:
                with connect(self.run, 2) as client:
                    client.sendall(request(self.run, "/events" if self.counts["leaves amid an answer"] % 2 else "/"))
                    client.recv(100)
                    self.counts["leaves amid an answer"] += 1
            except OSError:
                pass

    def many(self, count):
        """None waits for another to be accepted."""
        clients = [socket.socket() for _ in range(count)]
        for client in clients:
            client.setblocking(False)
            client.connect_ex(("127.0.0.1", self.run.port))
        self.counts["at once"] = count
        while not self.over.wait(0.2):
            for client in clients:
                try:
                    client.send(b"G")
                except OSError:
                    pass
        for client in clients:
            client.close()

    def asks(self, _):
        """An honest page amid the others."""
        while not self.over.wait(0.5):
            code, _ = answer(self.run, request(self.run), timeout=30)
            self.counts[f"honest page, {code}"] += 1

    def end(self):
        self.over.set()
        for thread in self.threads:
            thread.join()


def attacked_run(program, folder, plain, quick):
    run = Run(program, folder, "attacked", True)
    if run.port is None:
        sys.exit("the run gave no address: " + pathlib.Path(run.said.name).read_text())
    answer(run, request(run, "/control", "POST", body=b'{"action":"pause"}'))
    rows = list(single_requests(run))
    # So the crowd has its time, and costs no processor time of the run.
    answer(run, request(run, "/control", "POST", body=b'{"action":"slow","factor":%d}' % (QUICK_PACE if quick else 1)))
    answer(run, request(run, "/control", "POST", body=b'{"action":"resume"}'))
    begin = time.monotonic()
    crowd = Crowd(run, quick)
    watching = threading.Event()

    def watch():
        while not watching.wait(0.02):
            run.look()
    watcher = threading.Thread(target=watch)
    watcher.start()
    code = run.end()
    held_up = (time.monotonic() - begin) / (END / (QUICK_PACE if quick else 1))
    watching.set()
    watcher.join()
    crowd.end()
    for name, count in sorted(crowd.counts.items()):
        rows.append({"attack": name, "attempts": count, "answers": "", "allowed": "any", "good": "yes"})
        print(f"clients: {name}: {count}", flush=True)
    # The summary is the last file of a run.
    summary = run.folder / "summary.json"
    slowest_end = time.time() - summary.stat().st_mtime if summary.exists() else float("inf")
    try:
        connect(run, 1).close()
        closed = False
    except OSError:
        closed = True
    same = code == 0 and run.bits() == plain.bits()
    if code != 0:
        print(pathlib.Path(run.said.name).read_text()[-500:])
    rows += [judged("the run ends by itself", {f"exit code {code}": 1}, {"exit code 0"}),
             judged("the run keeps its bits", {"same" if same else "other": 1}, {"same"}),
             judged("open files at most", {str(run.most_files): 1}, {f"up to {MOST_FILES}"}, run.most_files <= MOST_FILES),
             judged("memory above a run without a live view [MB]", {f"{run.memory - plain.memory:.0f}": 1},
                    {f"up to {MOST_GROWTH}"}, run.memory - plain.memory <= MOST_GROWTH),
             judged("processor time, of a run without a live view [1]", {f"{run.seconds / plain.seconds:.2f}": 1}, {"any"}, True),
             # The quick form is too short for that.
             judged("time of the run, over that of its pace [1]", {f"{held_up:.2f}": 1},
                    {"any" if quick else f"up to {MOST_TIME}"}, quick or held_up <= MOST_TIME),
             judged("end of the program after that of the run [s]", {f"{slowest_end:.0f}": 1}, {f"up to {LONGEST_END}"},
                    slowest_end <= LONGEST_END),
             judged("the port is closed then", {"yes" if closed else "no": 1}, {"yes"})]
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--csv", type=pathlib.Path)
    options = parser.parse_args()
    resource.setrlimit(resource.RLIMIT_NOFILE, (4096, resource.getrlimit(resource.RLIMIT_NOFILE)[1]))
    program = str(options.program.resolve())
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        (folder / "s.xml").write_text(SCENE.format(end=END))
        plain = Run(program, folder, "plain", False)
        if plain.end() != 0:
            sys.exit("the run without a live view fails: " + pathlib.Path(plain.said.name).read_text())
        rows = attacked_run(program, folder, plain, options.quick)
    if options.csv:
        with open(options.csv, "w", newline="", encoding="utf-8") as out:
            table = csv.DictWriter(out, COLUMNS)
            table.writeheader()
            table.writerows(rows)
    bad = [row["attack"] for row in rows if row["good"] == "no"]
    print(f"{len(rows)} lines, not good: {', '.join(bad) or 'none'}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
