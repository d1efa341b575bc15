#!/usr/bin/env python3
"""When a station heard what of robots that started with it: starts.py STARTS ROBOTS.

STARTS has a folder for each start, as packaging/deb/in-root left it: when each process began, what it said when, and the log of
the station. ROBOTS has the files of kurt3d and crawler. Told is after how many seconds the last of all periodic streams of
both came, from when the last process began and from when the last one said that it is there. Fails where it took more
than 3 s from the first of these, and where the robots did not tell of hostile packets.
"""
import pathlib
import re
import sqlite3
import statistics
import sys

AT_MOST = 3.0  # [s]
PERIODIC = "points ranges odometry imu joints transforms picture camera_info thermal gas battery diagnostics".split()
THERE = {"kurt3d": " is in ", "crawler": " is in ", "recorder": "recording domain", "window": "recorded into"}


def streams(robot_file):
    """Role, topic and robot of all that a robot sends; the Crawler's laser does not turn, which makes no points."""
    text = re.sub(r"#.*", "", robot_file.read_text())
    robot = robot_file.stem
    for role, topic in re.findall(r"role: (\w+).*?topic: ([\w/]+)", text, re.DOTALL):
        if (robot, role) != ("crawler", "points"):
            yield role, topic, robot


def first_heard(log, topic, robot):
    """When the first sample came [s]; diagnostics are both robots' and tell whose they are."""
    query = "select min(m.timestamp) from messages m join topics t on m.topic_id = t.id where t.name = ?"
    whose = (topic,)
    if topic == "/diagnostics":
        query += " and instr(m.data, ?) > 0"
        whose += (robot.encode(),)
    stamp = log.execute(query, whose).fetchone()[0]
    return None if stamp is None else stamp / 1e9


def judge(folder, expected):
    """Kind, seconds from the last start, from when all were there, and what came last; in words what is wrong."""
    began = {part: float(when) for part, when in (line.split() for line in (folder / "began").read_text().splitlines())}
    said = {part: (folder / f"{part}.log").read_text(errors="replace") for part in began}
    there = []
    for part, text in said.items():
        there += [float(line.split()[0]) for line in text.splitlines() if THERE[part] in line][:1]
    kind = "window" if "window" in began else "recorder"
    if len(there) < len(began):
        return kind, None, None, "not all of them came"
    if not all("somebody sends" in said[robot] for robot in ("kurt3d", "crawler")):
        return kind, None, None, "no hostile packets fell on the robots"
    roles = PERIODIC + (["pong"] if kind == "window" else [])  # robots hear the station when they answer
    heard = {}
    for file in (folder / "mission").glob("*.db3"):  # one, of so short a mission
        log = sqlite3.connect(f"file:{file}?mode=ro", uri=True)
        heard = {(topic, robot): first_heard(log, topic, robot) for role, topic, robot in expected if role in roles}
    missing = [f"{topic} of {robot}" for (topic, robot), when in heard.items() if when is None]
    if missing or not heard:
        return kind, None, None, "never heard: " + (", ".join(missing) or "anything")
    last = max(heard, key=heard.get)
    return kind, heard[last] - max(began.values()), heard[last] - max(there), last[0]


def main():
    folders = sorted((path for path in pathlib.Path(sys.argv[1]).iterdir()), key=lambda path: int(path.name))
    robots = pathlib.Path(sys.argv[2])
    expected = [stream for name in ("kurt3d", "crawler") for stream in streams(robots / f"{name}.yaml")]
    results, bad = {}, []
    for folder in folders:
        kind, seconds, after, last = judge(folder, expected)
        if seconds is None or seconds > AT_MOST:
            bad.append(f"start {folder.name} ({kind}): {last}" + ("" if seconds is None else f" after {seconds:.2f} s"))
        if seconds is not None:
            results.setdefault(kind, []).append((seconds, max(0.0, after)))
    for kind, all_of_it in results.items():
        seconds, after = zip(*all_of_it)
        print(f"{len(seconds)} starts with a {kind}: everything heard {statistics.median(seconds):.2f} s (median) and at most "
              f"{max(seconds):.2f} s after the last one began, {statistics.median(after):.2f} s and {max(after):.2f} s after the last "
              "one was there")
    print("\n".join(bad + [f"{len(bad)} of {len(folders)} starts took more than {AT_MOST:.0f} s"]))
    return 1 if bad or not folders else 0


sys.exit(main())
