#!/usr/bin/env python3
"""Writes what `packaging/leitstand fuzz --all` found into a document, between two marks.

Usage: fuzz-table.py TABLE.tsv DOCUMENT.md; TABLE has a line a target: name, inputs, seconds, edges, findings.
"""
import re
import sys

BEGIN, END = "<!-- fuzz:begin, written by packaging/leitstand fuzz --all -->", "<!-- fuzz:end -->"


def table_of(lines):
    rows = [line.rstrip("\n").split("\t") for line in lines if line.strip()]
    text = ["| target | inputs | seconds | edges | findings |", "|---|--:|--:|--:|--:|"]
    for name, *figures in sorted(rows):
        text.append("| " + " | ".join([f"`{name}`"] + [f"{int(figure):,}" for figure in figures]) + " |")
    inputs, seconds, findings = (sum(int(row[i]) for row in rows) for i in (1, 2, 4))
    text.append(f"| {len(rows)} targets | {inputs:,} | {seconds:,} | | {findings:,} |")
    return "\n".join(text)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8") as table:
        text = table_of(table.readlines())
    with open(sys.argv[2], encoding="utf-8") as document:
        before = document.read()
    place = re.compile(re.escape(BEGIN) + ".*?" + re.escape(END), re.DOTALL)
    if not place.search(before):
        sys.exit(f"{sys.argv[2]}: expected {BEGIN} and {END}")
    with open(sys.argv[2], "w", encoding="utf-8") as document:
        document.write(place.sub(lambda _: f"{BEGIN}\n{text}\n{END}", before, count=1))


if __name__ == "__main__":
    main()
