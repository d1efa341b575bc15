"""Parts the sources of a target into groups that are each compiled as one unit.

    unity_groups.py ROOT CACHE TARGET SOURCE...

Prints `source;group` for each source, but for those that are compiled alone. In one unit, what files declare for themselves (in unnamed namespaces, static or as
macros) must not meet: files that declare the same name, or one that a header of another file declares, come into different
groups. Names are read by a plain scan, which rather parts two files too many than too few. CMake runs it when it
configures: where a new name meets another one, the compiler says so, and configuring again mends it.
"""
import json
import os
import re
import sys

LARGEST_GROUP = 12

COMMENT_OR_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.S)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]+"([^"]+)"', re.M)
MACRO = re.compile(r'^[ \t]*#[ \t]*define[ \t]+(\w+)', re.M)
ALONE = re.compile(r'\boperator (?:new|delete)\b')  # replaces the program's
DIRECTIVE = re.compile(r'^[ \t]*#(?:[^\n]*\\\n)*[^\n]*', re.M)
TYPE = re.compile(r'^(?:template\s*<.*?>\s*)?(?:typedef\b.*?|(?:struct|class|union|enum(?:\s+class|\s+struct)?|using|concept))\s+(\w+)', re.S)
# Using declarations, aliases of namespaces and friends may stand twice; macros of test cases make names by their arguments.
HARMLESS = re.compile(r'using (?:namespace )?[\w:]+$|namespace \w+ =|(?:TYPED_)?TEST(?:_[FP])?\b|INSTANTIATE_|[A-Z][A-Z0-9_]+ ?\(')
ALIAS = re.compile(r'using \w+ = ')
FUNCTION = re.compile(r'([A-Za-z_]\w*)\s*\(')
FURTHER = re.compile(r',\s*([A-Za-z_]\w*)\s*(?==|\{|\[|,|$)')
VARIABLE = re.compile(r'([A-Za-z_]\w*)\s*(?:\[[^\]]*\]\s*)*$')


def declared_names(statement):
    """The names that a statement at the level of a namespace declares."""
    statement = ' '.join(statement.split())
    if HARMLESS.match(statement):
        return []
    kind = TYPE.match(statement)
    if kind:
        return [kind[1]]
    head = re.sub(r'<[^<>]*>', '', re.sub(r'<[^<>]*>', '', statement.split('=', 1)[0]))
    head = re.sub(r'\[\[.*?\]\]|\b(?:alignas|noexcept|decltype|requires)\s*\([^()]*\)', '', head)
    function = FUNCTION.search(head)
    found = function or VARIABLE.search(head.strip())
    further = [] if function else FURTHER.findall(statement)
    return [found[1], *further] if found else []


def read(path):
    """Names that a file has for itself, names that it declares for others, and what it includes."""
    with open(path, encoding='utf-8', errors='replace') as file:
        text = file.read()
    if path.endswith('.cpp') and ALONE.search(text):
        return None, [], []
    includes = INCLUDE.findall(text)
    own, shared = dict.fromkeys(MACRO.findall(text) if path.endswith('.cpp') else [], ''), set()
    text = DIRECTIVE.sub('', COMMENT_OR_TEXT.sub(lambda part: ' ' if part[0].startswith('/') else '""', text))
    scopes, statement = [], ''  # of each brace: 'own', 'shared' (namespaces) or 'body'
    for part in re.split(r'([{};])', text):
        inside = scopes[-1] if scopes else 'shared'
        if part == '{':
            head = ' '.join(statement.split())
            if inside == 'body':
                scopes.append('body')
            elif re.fullmatch(r'(?:inline )?namespace', head):
                scopes.append('own')
            elif re.match(r'(?:inline )?namespace [\w:]+$', head) or head == 'extern ""':
                scopes.append(inside)
            else:
                note(statement, inside, own, shared)
                scopes.append('body')
            statement = ''
        elif part == '}':
            if scopes:
                scopes.pop()
            statement = ''
        elif part == ';':
            if inside != 'body':
                note(statement, inside, own, shared)
            statement = ''
        else:
            statement += part
    return own, sorted(shared), includes


def note(statement, inside, own, shared):
    if not statement.strip() or re.match(r'\s*[)\],.]', statement):
        return
    for name in declared_names(statement):
        if inside == 'own' or re.match(r'\s*static\b', statement):
            text = ' '.join(statement.split())
            own[name] = text if ALIAS.match(text) else ''  # the same alias may stand twice
        else:
            shared.add(name)


class Names:
    """What files declare, kept from one run to the next."""

    def __init__(self, root, cache):
        self.root, self.cache, self.known, self.changed = root, cache, {}, False
        self.version = os.stat(__file__).st_mtime_ns
        try:
            with open(cache, encoding='utf-8') as file:
                self.known = json.load(file)
        except (OSError, ValueError):
            pass

    def of(self, path):
        status = os.stat(path)
        stamp = [status.st_mtime_ns, status.st_size, self.version]
        kept = self.known.get(path)
        if kept is None or kept[0] != stamp:
            kept = self.known[path] = [stamp, *read(path)]
            self.changed = True
        return kept[1], kept[2], kept[3]

    def stands_alone(self, source):
        return self.of(source)[0] is None

    def own(self, source):
        """... of a source and of what it includes."""
        found = dict(self.of(source)[0])
        for header in self.headers(source):
            found.update(self.of(header)[0])
        return found

    def headers(self, source):
        found, left = set(), [source]
        while left:
            for include in self.of(left.pop())[2]:
                header = os.path.join(self.root, include)
                if header not in found and os.path.exists(header):
                    found.add(header)
                    left.append(header)
        return found

    def shared(self, source):
        """What the headers of a source declare for others, and the source itself."""
        return set().union(self.of(source)[1], *(self.of(header)[1] for header in self.headers(source)))

    def keep(self):
        if self.changed:
            with open(self.cache, 'w', encoding='utf-8') as file:
                json.dump(self.known, file)


def meet(own, others):
    return any(not text or text != others[name] for name, text in own.items() if name in others)


def main():
    root, cache, target = sys.argv[1:4]
    names = Names(root, cache)
    groups = []  # [sources, their own names, what their headers declare]
    for source in sys.argv[4:]:
        if names.stands_alone(source):
            continue
        own, shared = names.own(source), names.shared(source)
        for group in groups:
            if len(group[0]) < LARGEST_GROUP and not (
                    meet(own, group[1]) or own.keys() & group[2] or group[1].keys() & shared):
                break
        else:
            group = [[], {}, set()]
            groups.append(group)
        group[0].append(source)
        group[1].update(own)
        group[2] |= shared
    names.keep()
    for number, (sources, _, _) in enumerate(groups):
        for source in sources:
            print(f'{source};{target}_{number}')


if __name__ == '__main__':
    main()
