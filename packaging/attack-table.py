#!/usr/bin/env python3
"""Writes the tables "what was attacked, how often, what happened" of the documents from the output of tests.

Usage: attack-table.py OUTPUT DOCS; OUTPUT has lines "ATTACK|area|what|how often|what happened", the last one of each
attack counts. Each area has a table in a document of the folder DOCS, between two marks that name it.
"""
import pathlib
import re
import sys

MARKS = re.compile(
    r"(<!-- attacks:begin (\w+), written by packaging/leitstand test --long -->\n).*?(<!-- attacks:end -->)", re.DOTALL)


def attacks_of(lines):
    """Area -> what -> (how often, what happened), in the order in which they first came."""
    areas = {}
    for line in lines:
        at = line.find("ATTACK|")
        if at < 0:
            continue
        parts = line[at:].strip().split("|")
        if len(parts) != 5 or not parts[3].isdigit():
            sys.exit(f'attack-table.py: expected "ATTACK|area|what|how often|what happened", found "{line.strip()}"')
        areas.setdefault(parts[1], {})[parts[2]] = (int(parts[3]), parts[4])
    return areas


def table_of(attacks):
    rows = ["| attack | how often | what happened |", "|---|--:|---|"]
    return "\n".join(rows + [f"| {what} | {often:,} | {happened} |" for what, (often, happened) in attacks.items()])


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8", errors="replace") as output:
        areas = attacks_of(output)
    written = {}
    for document in sorted(pathlib.Path(sys.argv[2]).glob("*.md")):
        text = document.read_text(encoding="utf-8")
        places = [area for _, area, _ in MARKS.findall(text)]
        for area in places:
            if area not in areas:
                sys.exit(f"attack-table.py: {document} has a table of {area}, of which no test told")
        if places:
            written[document] = MARKS.sub(lambda place: f"{place[1]}{table_of(areas.pop(place[2]))}\n{place[3]}", text)
    if areas:
        sys.exit(f"attack-table.py: no document has a table of {', '.join(areas)}")
    for document, text in written.items():
        document.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
