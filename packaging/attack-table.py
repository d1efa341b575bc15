"""Writes the table "what was attacked, how often, what happened" of docs/security.md from the output of tests.

attack-table.py OUTPUT... [--area AREA] [--into docs/security.md]: lines "ATTACK|area|what|how often|what happened" of the
outputs ("-": of standard input), the last one of each attack in the area (wire; log: docs/mission-log.md; pictures),
between the marks of the document; without --into the table is printed. Lines without an area are of the wire's.
"""

import argparse
import sys

BEGIN, END = "<!-- attack-table -->", "<!-- /attack-table -->"


def attacks(lines, area):
    """What -> (how often, what happened) in the area, in the order in which they first came."""
    found = {}
    for line in lines:
        at = line.find("ATTACK|")
        parts = line[at:].strip().split("|") if at >= 0 else []
        if len(parts) == 4:
            parts.insert(1, "wire")
        if len(parts) == 5 and parts[1] == area and parts[3].isdigit():
            found[parts[2]] = (int(parts[3]), parts[4])
    return found


def table(found, area):
    rows = [f"| attack | {'packets' if area == 'wire' else 'times'} | what happened |", "|---|---|---|"]
    rows += [f"| {what} | {often:,} | {happened} |" for what, (often, happened) in found.items()]
    return "\n".join(rows)


def between_marks(text, content):
    head, begin, rest = text.partition(BEGIN)
    _, end, tail = rest.partition(END)
    if not begin or not end:
        raise SystemExit(f"attack-table.py: the document has no {BEGIN} and {END}")
    return f"{head}{BEGIN}\n{content}\n{END}{tail}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("outputs", nargs="+", help='files of test output; "-": standard input')
    parser.add_argument("--area", default="wire", help="wire, log or pictures")
    parser.add_argument("--into", help="document whose table is written anew")
    options = parser.parse_args()
    lines = []
    for name in options.outputs:
        with sys.stdin if name == "-" else open(name, encoding="utf-8", errors="replace") as output:
            lines += output.readlines()
    found = attacks(lines, options.area)
    if not found:
        raise SystemExit("attack-table.py: no line of an attack in the outputs")
    if not options.into:
        print(table(found, options.area))
        return
    with open(options.into, encoding="utf-8") as document:
        text = document.read()
    with open(options.into, "w", encoding="utf-8") as document:
        document.write(between_marks(text, table(found, options.area)))


if __name__ == "__main__":
    main()
