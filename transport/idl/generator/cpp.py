"""C++ from messages: plain structs with decode and encode for our CDR cursor, and the table of all types."""

from . import ros

NAMES = {'boolean': 'bool', 'octet': 'std::uint8_t', 'float': 'float', 'double': 'double',
         'string': 'std::string', **{f'{sign}int{bits}': f'std::{sign}int{bits}_t'
                                     for sign in ('', 'u') for bits in (8, 16, 32, 64)}}
SIZES = {'boolean': 1, 'octet': 1, 'int8': 1, 'uint8': 1, 'int16': 2, 'uint16': 2, 'int32': 4, 'uint32': 4,
         'float': 4, 'int64': 8, 'uint64': 8, 'double': 8, 'string': 4}
BYTES = ('octet', 'uint8')


def least_size(member, messages):
    """Bytes that @p member takes on the wire at least, without padding."""
    if member.is_sequence:
        return 4
    one = SIZES.get(member.base) or sum(least_size(m, messages) for m in messages[member.base].members)
    return one * (member.length or 1)


def _element(base):
    return NAMES.get(base) or '::leitstand::wire::' + base.replace('/msg/', '::')


def _type(member):
    if member.is_sequence:
        return 'std::span<const std::byte>' if member.base in BYTES else f'std::vector<{_element(member.base)}>'
    if member.length:
        return f'std::array<{_element(member.base)}, {member.length}>'
    return _element(member.base)


def _initial(member):
    plain = member.is_primitive and member.base != 'string' and not member.is_sequence
    return '{}' if member.length or plain else ''


def header(package, messages, all_messages):
    """The header with the structs of @p package."""
    used = sorted({m.base.split('/')[0] for message in messages for m in message.members
                   if not m.is_primitive} - {package})
    out = ['// Made from the IDL: do not edit.', '#pragma once', '',
           *(f'#include "messages/{name}.h"' for name in used), '#include "transport/cdr/cdr_reader.h"',
           '#include "transport/cdr/cdr_writer.h"', '',
           f'namespace leitstand::wire::{package} {{', '']
    for message in messages:
        out.append(f'struct {message.name} {{')
        for constant in message.constants:
            out.append(f'    static constexpr {NAMES[constant.base]} {constant.name}_ = {constant.value};')
        out += [f'    {_type(m)} {m.name}{_initial(m)};' for m in message.members]
        size = sum(least_size(m, all_messages) for m in message.members)
        out += [f'    static constexpr std::size_t LeastSize = {size};',
                f'    static constexpr const char* RosName = "{message.ros_name}";', '};',
                f'void decode(CdrReader& in, {message.name}& to);',
                f'void encode(CdrWriter& out, const {message.name}& from);', '']
    return '\n'.join(out + ['}', ''])


def source(package, messages):
    """The source with decode and encode of @p package."""
    out = ['// Made from the IDL: do not edit.', f'#include "messages/{package}.h"', '',
           f'namespace leitstand::wire::{package} {{', '']
    for message in messages:
        out.append(f'void decode(CdrReader& in, {message.name}& to) {{')
        out += [f'    in.read("{m.name}", to.{m.name});' for m in message.members]
        out += ['}', '', f'void encode(CdrWriter& out, const {message.name}& from) {{']
        out += [f'    out.write(from.{m.name});' for m in message.members]
        out += ['}', '']
    return '\n'.join(out + ['}', ''])


def table(messages):
    """The source with the table of all types."""
    out = ['// Made from the IDL: do not edit.', '#include "transport/convert/message_catalog.h"', '',
           'namespace leitstand {', '', 'namespace {', '', 'constexpr MessageType Types[] = {']
    for name in sorted(messages):
        message = messages[name]
        out.append(f'    {{"{name}", "{message.dds_name}", "{ros.type_hash(message, messages)}",\n'
                   f'     R"({ros.definition(message, messages)})"}},')
    return '\n'.join(out + ['};', '', '}', '', 'std::span<const MessageType> messageTypes() {',
                            '    return Types;', '}', '', '}', ''])
