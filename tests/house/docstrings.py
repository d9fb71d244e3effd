#!/usr/bin/env python3
"""Checks the docstrings of the headers of lib, mms and oned: docstrings.py SOURCE.

Every public declaration has one: what stands in a namespace of a header, but for forward declarations, instantiations and what is in
a namespace whose name ends in `detail`. Declarations that follow each other without an empty line share the docstring of the first. A docstring says
what the thing is: none begins with "of", "the same" or "likewise", which are about the line before. A remark behind
a member (`///<`) completes its name and may begin so. Exit code 1 if one is missing or begins so.
"""
import pathlib
import re
import sys

ROOMS = ("lib", "mms", "oned")
DANGLING = re.compile(r"(of|the same|likewise|and|ditto|as above)\b", re.IGNORECASE)
FORWARD = re.compile(r"(template\s*<[^;{]*>\s*)?(class|struct|enum( class)?|union)\s+\w+\s*(:\s*[\w:]+\s*)?;$")
OUTSIDE = re.compile(r"[^({=]*\w(<[\w, ]*>)?::~?\w+\(")  # the definition of a member, which its class declares
NOT_A_DECLARATION = re.compile(r"(extern\s+)?template\s+(?!<)|template\s*<>|static_assert|using namespace|friend\b")


def without_text(line):
    """The line without strings, characters and comments: only its brackets are looked at."""
    line = re.sub(r'"(\\.|[^"\\])*"', '""', line)
    line = re.sub(r"(?<![0-9a-fA-F])'(\\.|[^'\\])'", "' '", line)
    return line.split("//")[0]


def declarations(text):
    """(line, declaration, whether it has a docstring) of everything in namespaces of a header."""
    found, scopes, depth = [], [], 0  # scopes: names of namespaces; depth: brackets that are open within them
    documented = shared = False  # by the lines right above; by the first of the group
    explained = set()  # declarations with a docstring: their definitions below need none
    words, start, trailing, raw = "", 0, False, False
    for number, line in enumerate(text.splitlines(), 1):
        bare = line.strip()
        if raw or 'R"' in line:  # a raw string: skipped to its end
            raw = ')"' not in line.split('R"')[-1]
            continue
        if not words and depth == 0:
            if not bare:
                documented = shared = False
                continue
            if bare.startswith("///"):
                documented = True
                continue
            if bare.startswith(("//", "#")):
                continue
            opened = re.match(r"(inline )?namespace\s*([\w:]*)\s*{", bare)
            if opened:
                scopes.append(opened.group(2))
                documented = shared = False
                continue
            if bare.startswith("}") and scopes:
                scopes.pop()
                continue
            start, trailing = number, False
        code = without_text(line)
        words += code.strip() + " "
        trailing = trailing or ("///<" in line and (number == start or "{" not in words))
        depth += sum(code.count(c) for c in "({[") - sum(code.count(c) for c in ")}]")
        if depth > 0 or not code.rstrip().endswith((";", "}")):
            continue
        words = words.strip()
        if not FORWARD.match(words) and not NOT_A_DECLARATION.match(words) and not OUTSIDE.match(words) \
                and not any(name == "" or name.endswith("detail") for name in scopes):
            head = re.split(r"\s*[{;]", words)[0]
            if documented or trailing or shared:
                explained.add(head)
            found.append((start, words, head in explained))
            shared = shared or documented
        documented, words = False, ""
    return found


def openings(text):
    """(line, first words) of every docstring; those of members stand deeper."""
    lines = text.splitlines()
    for number, line in enumerate(lines, 1):
        if re.match(r"\s*///(?!<)", line) and not (number > 1 and re.match(r"\s*///(?!<)", lines[number - 2])):
            yield number, re.sub(r"^\s*///\s*", "", line)


def main(arguments):
    source = pathlib.Path(arguments[0])
    headers = sorted(path for room in ROOMS for path in (source / room).rglob("*.hpp"))
    complaints, count, docstrings = [], 0, 0
    for path in headers:
        text, name = path.read_text(), path.relative_to(source)
        for line, words, documented in declarations(text):
            count += 1
            if not documented:
                complaints.append(f"{name}:{line}: no docstring: {words[:90]}")
        for line, words in openings(text):
            docstrings += 1
            if DANGLING.match(words):
                complaints.append(f"{name}:{line}: begins with \"{words[:60]}\"")
    print("\n".join(complaints))
    print(f"{count} public declarations, {docstrings} docstrings in {len(headers)} headers, {len(complaints)} complaints")
    if count < 1140 or docstrings < 1500:  # as many as there were when this was written, less a tenth: else nothing was looked at
        print("too few: the headers were not read")
        return 1
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
