#!/usr/bin/env python3
"""generate_fill.py OUT GENERATOR FILE.idl...: from the same IDL that the product reads, code that fills every
message with values from a seed: peer_types.c for the structs of Cyclone's idlc, our_types.cpp for our own."""

import sys
from pathlib import Path


def c_name(message):
    return f'{message.package}_msg_dds__{message.name}_'


def c_value(member, messages, place):
    """The statement that fills @p place in C."""
    base = member.base
    if base == 'string':
        return f'fill_text(s, text); {place} = dds_string_dup(text);'
    if base in ('float', 'double'):
        return f'{place} = ({base})fill_real(s);'
    if base == 'boolean':
        return f'{place} = fill_next(s) % 2U != 0U;'
    if member.is_primitive:
        kind = 'uint8_t' if base == 'octet' else f'{base}_t'
        return f'{place} = ({kind})fill_next(s);'
    return f'fill_{c_name(messages[base])}(s, &{place});'


def c_member(member, messages):
    place = f'to->{member.name}'
    if member.is_sequence:
        count = 'fill_byte_count' if member.base in ('octet', 'uint8') else 'fill_count'
        return [f'{place}._length = {place}._maximum = {count}(s);',
                f'{place}._buffer = dds_alloc({place}._length * sizeof *{place}._buffer);',
                f'{place}._release = true;',
                f'for (uint32_t i = 0; i < {place}._length; ++i) {{ '
                + c_value(member, messages, f'{place}._buffer[i]') + ' }']
    if member.length:
        return [f'for (uint32_t i = 0; i < {member.length}; ++i) {{ '
                + c_value(member, messages, f'{place}[i]') + ' }']
    return [c_value(member, messages, place)]


def c_source(messages, files):
    out = ['#include "peer_types.h"', '#include "fill_random.h"', *(f'#include "{f.stem}.h"' for f in files), '']
    for message in messages.values():
        out += [f'static void fill_{c_name(message)}(uint64_t* s, {c_name(message)}* to) {{',
                '    char text[41];', '    (void)text;',
                *(f'    {line}' for m in message.members for line in c_member(m, messages)), '}',
                f'static void fill_any_{c_name(message)}(uint64_t* s, void* to) {{',
                f'    fill_{c_name(message)}(s, ({c_name(message)}*)to);', '}', '']
    out.append('const struct PeerType peer_types[] = {')
    out += [f'    {{"{m.package}/{m.name}", &{c_name(m)}_desc, sizeof({c_name(m)}), fill_any_{c_name(m)}}},'
            for m in messages.values()]
    return '\n'.join(out + ['};', f'const unsigned peer_type_count = {len(messages)};', ''])


def cpp_value(member, kind, place):
    base = member.base
    if base == 'string':
        return f'fill_text(s, text); {place} = text;'
    if base in ('float', 'double'):
        return f'{place} = static_cast<{base}>(fill_real(s));'
    if base == 'boolean':
        return f'{place} = fill_next(s) % 2U != 0U;'
    if member.is_primitive:
        return f'{place} = static_cast<{kind}>(fill_next(s));'
    return f'fill(s, {place}, bytes);'


def cpp_member(member, names):
    place = f'to.{member.name}'
    kind = names.get(member.base, '')
    if member.is_sequence and member.base in ('octet', 'uint8'):
        return [f'auto& own = bytes.emplace_back(fill_byte_count(s));',
                'for (std::byte& byte : own) byte = static_cast<std::byte>(fill_next(s));', f'{place} = own;']
    if member.is_sequence:
        return [f'{place}.resize(fill_count(s));',
                f'for (std::size_t i = 0; i < {place}.size(); ++i) {{ '
                + cpp_value(member, kind, f'{place}[i]') + ' }']
    if member.length:
        return [f'for (auto& one : {place}) {{ ' + cpp_value(member, kind, 'one') + ' }']
    return [cpp_value(member, kind, place)]


def cpp_source(messages, files, names):
    out = ['#include "tests/transport/cyclone/our_types.h"', '', '#include <deque>', '',
           *(f'#include "messages/{f.stem}.h"' for f in files),
           '#include "tests/transport/cyclone/peer/fill_random.h"', '', 'namespace leitstand::test {',
           'namespace {', 'using Bytes = std::deque<std::vector<std::byte>>;', '']
    for message in messages.values():
        own = f'wire::{message.package}::{message.name}'
        out += [f'[[maybe_unused]] void fill(std::uint64_t* s, {own}& to, [[maybe_unused]] Bytes& bytes) {{',
                '    [[maybe_unused]] char text[41];']
        for member in message.members:
            out += ['    {', *(f'        {line}' for line in cpp_member(member, names)), '    }']
        out += ['}', '']
    out += ['template <class Message>', 'std::vector<std::byte> encoded(std::uint64_t seed) {',
            '    Message message;', '    Bytes bytes;', '    fill(&seed, message, bytes);', '    CdrWriter out;',
            '    encode(out, message);', '    return std::move(out).finish();', '}', '', '}  // namespace', '',
            'const std::vector<OurType>& ourTypes() {', '    static const std::vector<OurType> all = {']
    out += [f'        {{"{m.ros_name}", "{m.package}/{m.name}", encoded<wire::{m.package}::{m.name}>}},'
            for m in messages.values()]
    return '\n'.join(out + ['    };', '    return all;', '}', '', '}  // namespace leitstand::test', ''])


def main(folder, generator, *files):
    sys.path.insert(0, generator)
    from generator import cpp, idl
    files = [Path(f) for f in files]
    messages = idl.read_all(files)
    Path(folder).mkdir(parents=True, exist_ok=True)
    (Path(folder) / 'peer_types.c').write_text(c_source(messages, files))
    (Path(folder) / 'our_types.cpp').write_text(cpp_source(messages, files, cpp.NAMES))


if __name__ == '__main__':
    main(*sys.argv[1:])
