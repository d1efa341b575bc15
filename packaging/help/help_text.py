"""Reads what programs of ours print for --help (CLI11's form)."""

import re
import subprocess
from dataclasses import dataclass, field


@dataclass
class Entry:
    """One option, argument or subcommand."""

    names: list  # ["-h", "--help"]; one for arguments and subcommands
    value: str  # "M (0.10)"; empty: a flag, a subcommand
    text: str


@dataclass
class Section:
    title: str  # "Options", "Live robots"
    entries: list = field(default_factory=list)


@dataclass
class Command:
    """A program or one of its subcommands."""

    words: list  # ["leitstandctl", "keys", "show"]
    about: str = ""
    usage: str = ""
    sections: list = field(default_factory=list)
    footer: str = ""
    subcommands: list = field(default_factory=list)

    def entries(self, *titles):
        return [entry for section in self.sections if section.title in titles for entry in section.entries]

    def options(self):
        """All that begins with a dash, in whatever section it stands."""
        return [e for s in self.sections if s.title not in ("Positionals", "Subcommands") for e in s.entries]

    def all(self):
        """This command and all below it."""
        yield self
        for below in self.subcommands:
            yield from below.all()


def conditions_of(value):
    """A value without what CLI11 notes behind it, and that as words for the text."""
    told = ""
    for note, words in (("Needs", "only with"), ("Excludes", "not with")):
        if found := re.search(rf"\s*{note}: ((?:-\S+ ?)+)", value):
            value = value.replace(found[0], " ").strip()
            told += f"; {words} {', '.join(found[1].split())}"
    if value.endswith("REQUIRED") or " REQUIRED" in value:
        value = re.sub(r"\s*\bREQUIRED\b", "", value).strip()
        told += "; must be given"
    value = re.sub(r"^([A-Z]+):(INT|UINT|FLOAT|DIR)\b", r"\1", value)  # "N:INT in [0 - 132]": both name it
    value = re.sub(r"(\.\.\.)\s*\.\.\.", r"\1", value)
    return value, told


TEXT_COLUMN = 30  # where CLI11 begins an entry's text; a longer head has it on the next line


def entry_of(line, rest):
    """From "  -h,--help   Print this" and the lines that go on with its text."""
    head, text = line.strip(), ""
    padded = line[TEXT_COLUMN - 2 : TEXT_COLUMN] == "  " or (line[TEXT_COLUMN - 1 : TEXT_COLUMN] == " " and not rest)
    if padded:
        head, text = line[:TEXT_COLUMN].strip(), line[TEXT_COLUMN:].strip()
    elif not rest and "  " in head:  # a program that prints its help itself, in narrower columns
        head, _, text = head.partition("  ")
        text = text.strip()
    names, _, value = head.partition(" ")
    names = names.split(",")
    if ":" in names[0]:  # "--domain:INT", of an option without a name of its value
        names[0], _, value = head.partition(":")
    value, conditions = conditions_of(value.strip().removeprefix(":"))
    if "{" in names[-1]:  # "--no-pdf{false}"
        names[-1] = names[-1].partition("{")[0]
    return Entry(names, value, " ".join([text, *rest]).strip() + conditions)


def parse(words, text):
    """The Command that @p text, printed for --help of @p words, tells."""
    command = Command(words)
    lines = text.rstrip("\n").split("\n")
    above, section, index = [], None, 0
    while index < len(lines):
        line = lines[index]
        index += 1
        title = re.fullmatch(r"(\S[^:]*):", line)
        if not command.usage and section is None and line != "Options:":
            if line.lower().startswith("usage:"):
                command.usage = line.partition(":")[2].strip()
            else:
                above.append(line)
        elif title and index < len(lines) and re.match(r"  \S", lines[index]) and not command.footer:
            name = title[1].capitalize() if title[1].isupper() else title[1]
            # An "Examples:" of a footer is none of ours: entries stand at two blanks, words of a list at three.
            if not re.match(r"  (-|\S+( |$))", lines[index]) or re.match(r"  \d\.", lines[index]):
                command.footer = "\n".join(lines[index - 1 :])
                break
            section = Section(name)
            command.sections.append(section)
        elif section is not None and re.match(r"  \S", line):
            rest = []
            while index < len(lines) and lines[index].startswith(" " * 20):
                rest.append(lines[index].strip())
                index += 1
            section.entries.append(entry_of(line, rest))
        elif line.strip():
            command.footer = "\n".join(lines[index - 1 :])
            break
    command.about = " ".join(" ".join(above).split())
    command.usage = command.usage or f"{words[0]} [OPTIONS]"
    return command


def read(program, words=None):
    """The Command of the file @p program and all its subcommands, asked for their help."""
    words = words or [program.rpartition("/")[2]]
    asked = subprocess.run(
        [program, *words[1:], "--help"], stdout=subprocess.PIPE, check=True, timeout=60, encoding="utf-8"
    )
    command = parse(words, asked.stdout)
    for entry in command.entries("Subcommands"):
        command.subcommands.append(read(program, [*words, entry.names[0]]))
    return command
