#!/usr/bin/env python3
"""generate.py OUT FILE.idl...: writes messages/<package>.h, .cpp and messages/message_table.cpp below OUT."""

import sys
from pathlib import Path

from generator import cpp, idl


def write(path, text):
    """Leaves a file alone that would not change, so that nothing is compiled again."""
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def main(arguments):
    if len(arguments) < 2:
        sys.exit(__doc__)
    folder = Path(arguments[0]) / 'messages'
    folder.mkdir(parents=True, exist_ok=True)
    paths = [Path(argument) for argument in arguments[1:]]
    try:
        messages = idl.read_all(paths)
    except idl.IdlError as error:
        sys.exit(f'generate.py: {error}')
    for path in paths:
        own = [message for message in messages.values() if message.package == path.stem]
        write(folder / f'{path.stem}.h', cpp.header(path.stem, own, messages))
        write(folder / f'{path.stem}.cpp', cpp.source(path.stem, own))
    write(folder / 'message_table.cpp', cpp.table(messages))


if __name__ == '__main__':
    main(sys.argv[1:])
