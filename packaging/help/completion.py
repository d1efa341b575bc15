"""Makes the completion of a shell of what programs print for --help: completion.py bash|zsh OUT PROGRAM"""

import re
import sys

from help_text import read


def choices(entry):
    """What an option takes, where its help lists that; else nothing: a file, a number, a name."""
    value = entry.value
    if found := re.search(r"\{([^}]*)\}", value):
        return found[1].split(",")
    listed = re.sub(r"\s*\(.*\)$", "", value)
    if "|" in listed:
        return [one for one in listed.split("|") if not one.isupper()]
    if found := re.match(r"((?:[\w-]+, )*[\w-]+ or [\w-]+)(?:$|[ ,;(])", entry.text):
        if value and all(re.fullmatch(r"[a-z0-9-]+", one) for one in re.split(r", | or ", found[1])):
            return re.split(r", | or ", found[1])
    return []


def takes_value(entry):
    return bool(entry.value)


def function_of(name):
    return "_" + name.replace("-", "_")


def bash(command):
    name = command.words[0]
    below = [one for one in command.all()]
    out = [f"# Completion of {name}'s command line in bash; made of what it prints for --help.", f"{function_of(name)}() {{"]
    out += ['    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}', f"    local at={name} one"]
    out += ['    for one in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do', '        case "$at $one" in']
    for one in below:
        if len(one.words) > 1:
            out.append(f"        '{' '.join(one.words)}') at='{' '.join(one.words)}' ;;")
    out += ["        *) ;;", "        esac", "    done", "    COMPREPLY=()", '    case "$at $before" in']
    files = []
    for one in below:
        for entry in one.options():
            patterns = [f"'{' '.join(one.words)} {option}'" for option in entry.names]
            if listed := choices(entry):
                words = " ".join(listed)
                out += [f"    {' | '.join(patterns)})", f"        mapfile -t COMPREPLY < <(compgen -W '{words}' -- \"$word\")"]
                out += ["        return 0", "        ;;"]
            elif takes_value(entry):
                files += patterns
    if files:
        out += [f"    {' | '.join(files)})", "        compopt -o default 2>/dev/null", "        return 0", "        ;;"]
    out += ["    *) ;;", "    esac", "    local words=", '    case "$at" in']
    for one in below:
        options = [name for entry in one.options() for name in entry.names]
        commands = [child.words[-1] for child in one.subcommands]
        out.append(f"    '{' '.join(one.words)}') words='{' '.join(commands + options)}' ;;")
    out += ["    *) ;;", "    esac"]
    out.append("    # Options where one is begun, and commands; else what stands in the folder.")
    out.append('    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")')
    out.append("    [ ${#COMPREPLY[@]} -gt 0 ] || compopt -o default 2>/dev/null")
    out += ["    return 0", "}", f"complete -F {function_of(name)} {name}"]
    return "\n".join(out) + "\n"


def zsh_text(text):
    text = text.replace("\\", "\\\\").replace("[", "\\[").replace("]", "\\]").replace(":", "\\:")
    return text.replace("'", "'\\''")


def zsh_option(entry):
    value = ""
    if listed := choices(entry):
        value = f":{zsh_text(entry.names[-1].lstrip('-'))}:({' '.join(listed)})"
    elif takes_value(entry):
        value = f":{zsh_text(entry.value.split()[0].rstrip('.'))}:_files"
    repeated = "*" if "..." in entry.value else ""
    return [f"'{repeated}{name}[{zsh_text(entry.text)}]{value}'" for name in entry.names]


def zsh_function(command):
    name = "_" + "_".join(word.replace("-", "_") for word in command.words)
    specs = [spec for entry in command.options() for spec in zsh_option(entry)]
    out = [f"{name}() {{"]
    if command.subcommands:
        out += ['    local curcontext="$curcontext" state line', "    typeset -A opt_args", "    _arguments -C \\"]
        out += [f"        {spec} \\" for spec in specs]
        out += ["        '1:command:->command' '*::argument:->argument'", "    case $state in", "    command)"]
        out.append("        local -a commands=(")
        out += [f"            '{child.words[-1]}:{zsh_text(child.about)}'" for child in command.subcommands]
        out += ["        )", "        _describe command commands", "        ;;", "    argument)", "        case $line[1] in"]
        out += [f"        {child.words[-1]}) {name}_{child.words[-1].replace('-', '_')} ;;" for child in command.subcommands]
        out += ["        esac", "        ;;", "    esac"]
    else:
        out.append("    _arguments \\")
        out += [f"        {spec} \\" for spec in specs]
        out.append("        '*:file:_files'")
    out.append("}")
    for child in command.subcommands:
        out = [*zsh_function(child), "", *out]
    return out


def zsh(command):
    name = command.words[0]
    out = [f"#compdef {name}", f"# Completion of {name}'s command line in zsh; made of what it prints for --help.", ""]
    return "\n".join([*out, *zsh_function(command), "", f'{function_of(name)} "$@"']) + "\n"


def main(shell, out, program):
    with open(out, "w", encoding="utf-8") as file:
        file.write({"bash": bash, "zsh": zsh}[shell](read(program)))


if __name__ == "__main__":
    main(*sys.argv[1:])
