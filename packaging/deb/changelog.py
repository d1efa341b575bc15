"""Makes Debian's changelog of CHANGELOG.md: changelog.py CHANGELOG.md OUT. Each release with its date becomes an entry;
what is not released yet is none."""

import datetime
import re
import sys

MAINTAINER = "The Leitstand authors <maintainers@leitstand.example>"


def releases(text):
    """(version, date, lines) of each release, newest first."""
    found = []
    for line in text.split("\n"):
        if heading := re.fullmatch(r"## ([0-9.]+) \((\d{4}-\d\d-\d\d)\)", line):
            found.append((heading[1], heading[2], []))
        elif line.startswith("## "):
            found.append((None, None, []))
        elif found:
            found[-1][2].append(line)
    return [one for one in found if one[0]]


def entry(version, date, lines):
    day = datetime.date.fromisoformat(date)
    stamp = f"{day:%a, %d %b %Y} 12:00:00 +0000"
    summary = [f"  * {line[2:]}" for line in lines if line.startswith("> ")]
    summary = summary or [f"  * Release {version}; /usr/share/doc/leitstand/CHANGELOG.md tells what is new."]
    return "\n".join([f"leitstand ({version}) unstable; urgency=medium", "", *summary, "", f" -- {MAINTAINER}  {stamp}", ""])


def main(source, out):
    with open(source, encoding="utf-8") as file:
        found = releases(file.read())
    if not found:
        sys.exit(f"{source}: expected a heading such as \"## 0.2.0 (2026-11-25)\"")
    with open(out, "w", encoding="utf-8") as file:
        file.write("\n".join(entry(*one) for one in found))


if __name__ == "__main__":
    main(*sys.argv[1:])
