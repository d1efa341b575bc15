"""What ROS 2 makes of a message: its text as bags store it, and its type hash."""

import hashlib
import json

EMPTY = 'structure_needs_at_least_one_member'  # the byte that stands for an empty message on the wire
TEXT_NAMES = {'boolean': 'bool', 'octet': 'byte', 'float': 'float32', 'double': 'float64'}
# Of type_description_interfaces/msg/FieldType (REP 2016).
TYPE_IDS = {'int8': 2, 'uint8': 3, 'int16': 4, 'uint16': 5, 'int32': 6, 'uint32': 7, 'int64': 8, 'uint64': 9,
            'float': 10, 'double': 11, 'boolean': 15, 'octet': 16, 'string': 17}
NESTED, ARRAY, UNBOUNDED_SEQUENCE = 1, 48, 144


def needed(message, messages):
    """ROS names of all messages within @p message, sorted."""
    found = set()

    def add(one):
        for member in one.members:
            if not member.is_primitive and member.base not in found:
                found.add(member.base)
                add(messages[member.base])

    add(message)
    return sorted(found)


def _own_text(message):
    lines = [f'{TEXT_NAMES.get(c.base, c.base)} {c.name}={c.value}' for c in message.constants]
    for member in message.members:
        if member.name == EMPTY:
            continue
        base = TEXT_NAMES.get(member.base, member.base.replace('/msg/', '/'))
        brackets = '[]' if member.is_sequence else f'[{member.length}]' if member.length else ''
        lines.append(f'{base}{brackets} {member.name}')
    return ''.join(line + '\n' for line in lines)


def definition(message, messages):
    """Encoding "ros2msg" of rosbag2: the message, then each that it holds behind a line of 80 "=", named as the
    fields name it, since readers of bags compare the two."""
    parts = [_own_text(message)]
    for name in needed(message, messages):
        parts.append('=' * 80 + f'\nMSG: {name.replace("/msg/", "/")}\n' + _own_text(messages[name]))
    return ''.join(parts)


def _description(message):
    fields = []
    for member in message.members:
        offset = UNBOUNDED_SEQUENCE if member.is_sequence else ARRAY if member.length else 0
        fields.append({'name': member.name, 'type': {
            'type_id': offset + TYPE_IDS.get(member.base, NESTED),
            'capacity': member.length or 0,
            'string_capacity': 0,
            'nested_type_name': '' if member.is_primitive else member.base}})
    return {'type_name': message.ros_name, 'fields': fields}


def type_hash(message, messages):
    """RIHS01 of REP 2016: SHA-256 over the canonical JSON of the type description."""
    text = json.dumps({'type_description': _description(message),
                       'referenced_type_descriptions': [_description(messages[name])
                                                        for name in needed(message, messages)]},
                      separators=(', ', ': '))
    return 'RIHS01_' + hashlib.sha256(text.encode()).hexdigest()
