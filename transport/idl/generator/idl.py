"""Reads the subset of IDL that ROS messages need: modules, constants, structs of plain members."""

import re
from dataclasses import dataclass, field
from pathlib import Path

PRIMITIVES = {'boolean', 'octet', 'int8', 'uint8', 'int16', 'uint16', 'int32', 'uint32', 'int64', 'uint64',
              'float', 'double', 'string'}

TOKEN = re.compile(r'\s+|//[^\n]*|@final\b|(?P<word>[A-Za-z_][\w:]*)|(?P<number>-?\d+)|(?P<sign>[{}<>;=\[\]])')


class IdlError(Exception):
    """What is wrong with the IDL, with file and line."""


@dataclass
class Member:
    """A field: base is one of PRIMITIVES, or the ROS name of a message ("std_msgs/msg/Header")."""
    name: str
    base: str
    is_sequence: bool = False
    length: int | None = None  # of an array

    @property
    def is_primitive(self):
        return self.base in PRIMITIVES


@dataclass
class Constant:
    name: str
    base: str
    value: int


@dataclass
class Message:
    package: str
    name: str
    constants: list[Constant] = field(default_factory=list)
    members: list[Member] = field(default_factory=list)

    @property
    def ros_name(self):
        return f'{self.package}/msg/{self.name}'

    @property
    def dds_name(self):
        return f'{self.package}::msg::dds_::{self.name}_'


class Reader:
    """Recursive descent over the tokens of one file; a file defines the messages of one package."""

    def __init__(self, path: Path):
        self.path = path
        text = re.sub(r'^#include .*$', '', path.read_text(), flags=re.MULTILINE)
        self.tokens = self._tokens(text)
        self.place = 0
        self.messages: list[Message] = []
        self.constants: dict[str, list[Constant]] = {}

    def _tokens(self, text):
        found, at = [], 0
        while at < len(text):
            match = TOKEN.match(text, at)
            line = text.count('\n', 0, at) + 1
            if not match:
                raise IdlError(f'{self.path}:{line}: unexpected "{text[at]}"')
            if match.lastgroup:
                found.append((match.group(), line))
            at = match.end()
        return found

    def _fail(self, expected):
        text, line = self.tokens[self.place] if self.place < len(self.tokens) else ('end of file', 0)
        raise IdlError(f'{self.path}:{line}: expected {expected}, found "{text}"')

    def _peek(self):
        return self.tokens[self.place][0] if self.place < len(self.tokens) else ''

    def _take(self, expected=None):
        token = self._peek()
        if not token or (expected and token != expected):
            self._fail(f'"{expected}"' if expected else 'more')
        self.place += 1
        return token

    def read(self):
        package = self.path.stem
        for name in (package, 'msg', 'dds_'):
            self._take('module'), self._take(name), self._take('{')
        while self._peek() != '}':
            {'module': self._constants, 'struct': self._struct}.get(
                self._peek(), lambda: self._fail('"module" or "struct"'))()
        for _ in range(3):
            self._take('}'), self._take(';')
        return self.messages

    def _constants(self):
        self._take('module')
        name = self._take().removesuffix('_Constants')
        self._take('{')
        while self._peek() == 'const':
            self._take()
            base = self._take()
            constant = self._take().removeprefix('_')  # IDL's escape for names that are its own words
            self._take('=')
            self.constants.setdefault(name, []).append(Constant(constant, base, int(self._take())))
            self._take(';')
        self._take('}'), self._take(';')

    def _struct(self):
        self._take('struct')
        name = self._take().removesuffix('_')
        message = Message(self.path.stem, name, self.constants.get(name, []))
        self._take('{')
        while self._peek() != '}':
            message.members.append(self._member())
        self._take('}'), self._take(';')
        self.messages.append(message)

    def _member(self):
        base = self._take()
        is_sequence = base == 'sequence'
        if is_sequence:
            self._take('<')
            base = self._take()
            self._take('>')
        if base not in PRIMITIVES:
            parts = base.split('::')
            if len(parts) != 4 or parts[1:3] != ['msg', 'dds_'] or not parts[3].endswith('_'):
                self.place -= 1
                self._fail('a primitive type or package::msg::dds_::Name_')
            base = f'{parts[0]}/msg/{parts[3][:-1]}'
        member = Member(self._take(), base, is_sequence)
        if self._peek() == '[':
            self._take()
            member.length = int(self._take())
            self._take(']')
        self._take(';')
        return member


def read_all(paths):
    """All messages of the files by ROS name, in an order in which every message follows those it holds."""
    found = {message.ros_name: message for path in paths for message in Reader(path).read()}
    ordered: dict[str, Message] = {}

    def add(name, user):
        if name not in found:
            raise IdlError(f'{user} holds {name}, which no file defines')
        for member in found[name].members:
            if not member.is_primitive and member.base not in ordered:
                add(member.base, name)
        ordered.setdefault(name, found[name])

    for name in found:
        add(name, name)
    return ordered
