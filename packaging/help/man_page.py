"""Makes a man page of what a program prints for --help and of prose that we wrote:
man_page.py PROGRAM PROSE VERSION DATE OUT"""

import sys

from help_text import read


def escaped(text):
    """Text as roff takes it: nothing of it is a command, dashes are those that people type."""
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq").replace("`", "\\(ga")
    return "\\&" + text if text.startswith((".", "\\(aq")) else text


def prose(file):
    """Sections of a prose file, by title: "# TITLE", paragraphs, "- term: text" for lists, indented examples."""
    sections, title = {}, None
    with open(file, encoding="utf-8") as lines:
        for line in lines.read().split("\n"):
            if line.startswith("# "):
                title = line[2:].strip()
                sections[title] = []
            elif title is not None:
                sections[title].append(line)
    return sections


def set_prose(lines):
    out, example = [], False
    for line in lines:
        if line.startswith("    "):
            if not example:
                out += [".PP", ".RS 4", ".nf"]
            example = True
            out.append(escaped(line[4:]))
            continue
        if example and line.strip():
            out += [".fi", ".RE", ".PP"]
            example = False
        if line.startswith("- "):
            term, _, text = line[2:].partition(": ")
            out += [".TP", f"\\fB{escaped(term)}\\fR", escaped(text)]
        elif line.strip():
            out.append(escaped(line.strip()))
        elif out and not example and out[-1] != ".PP":
            out.append(".PP")
    if example:
        out += [".fi", ".RE"]
    while out and out[-1] == ".PP":
        out.pop()
    return out


def entries(section):
    out = []
    for entry in section:
        names = ", ".join(f"\\fB{escaped(name)}\\fR" for name in entry.names)
        value = f" \\fI{escaped(entry.value)}\\fR" if entry.value else ""
        out += [".TP", names + value, escaped(entry.text)]
    return out


def set_footer(text):
    return [".PP", ".nf", *(escaped(line) or "\\&" for line in text.strip("\n").split("\n")), ".fi"]


def set_command(command, above):
    out = [f".SS \"{escaped(' '.join(command.words))}\"", escaped(command.about + ".")]
    out += [".PP", f"\\fB{escaped(command.usage)}\\fR"]
    for section in command.sections:
        if section.title == "Subcommands":
            continue
        out += entries(section.entries)
    if command.footer and command.footer != above.footer:
        out += set_footer(command.footer)
    for below in command.subcommands:
        out += set_command(below, command)
    return out


def page(command, sections, version, date):
    name = command.words[0]
    out = [f'.TH {name.upper()} 1 "{date}" "Leitstand {version}" "Leitstand"']
    out += [".SH NAME", f"{escaped(name)} \\- {escaped(' '.join(sections['NAME']).strip())}"]
    out += [".SH SYNOPSIS", f".B {escaped(command.usage)}"]
    out += [".SH DESCRIPTION", *set_prose(sections["DESCRIPTION"])]
    for section in command.sections:
        if section.title == "Subcommands":
            continue
        title = {"Positionals": "ARGUMENTS"}.get(section.title, section.title.upper())
        out += [f".SH {title}", *entries(section.entries)]
    if command.footer:
        out += set_footer(command.footer)
    if command.subcommands:
        out.append(".SH COMMANDS")
        for below in command.subcommands:
            out += set_command(below, command)
    for title, lines in sections.items():
        if title not in ("NAME", "DESCRIPTION"):
            out += [f".SH {title}", *set_prose(lines)]
    return "\n".join(out) + "\n"


def main(program, prose_file, version, date, out):
    with open(out, "w", encoding="utf-8") as file:
        file.write(page(read(program), prose(prose_file), version, date))


if __name__ == "__main__":
    main(*sys.argv[1:])
