#!/usr/bin/env python3
"""Checks that rooms include only the rooms that lib/theory/decisions.md allows: arrows.py SOURCE.

Exit code 1 if an include is not in the list, if the list has a line that no include needs, or if rooms include each other in a circle.
"""
import pathlib
import re
import sys

PARTS = ("mms", "oned", "reports", "verification")


def room_of(path, rooms):
    """The room of a path in the tree, the deepest one of the list that holds it; a folder that no line names is a room of its own.
    None outside of the rooms."""
    folder = path.parts[:-1]
    if not folder or folder[0] in PARTS:
        return folder[0] if folder else None
    if folder[0] != "lib" or len(folder) < 2:
        return None
    names = ["/".join(folder[1:n]) for n in range(len(folder), 1, -1)]
    if names[-1] == "schemes" and len(folder) > 2 and not any(n in rooms for n in names[:-1]):
        return names[-2]  # every scheme is a room
    return next((n for n in names if n in rooms), names[-1])


def arrows_of(source, rooms):
    """{(room, included room): a file that does it} over the whole tree."""
    found = {}
    for path in sorted(source.glob("*/**/*.[ch]pp")):
        inside = path.relative_to(source)
        room = room_of(inside, rooms)
        if room is None:
            continue
        for words in re.findall(r'^#include "([^"]+)"', path.read_text(), re.MULTILINE):
            other = room_of(pathlib.PurePath(words), rooms)
            if other and other != room:
                found.setdefault((room, other), inside)
    return found


def allowed_by(text):
    """{(room, room)} of the list in the page, and the rooms in its order."""
    rows = re.search(r"```arrows\n(.*?)```", text, re.DOTALL)
    if not rows:
        sys.exit("lib/theory/decisions.md has no list of arrows")
    pairs, rooms = set(), []
    for row in rows.group(1).splitlines():
        room, _, others = row.partition(":")
        rooms.append(room)
        pairs |= {(room, other) for other in others.split()}
    return pairs, rooms


def main():
    source = pathlib.Path(sys.argv[1])
    allowed, rooms = allowed_by((source / "lib/theory/decisions.md").read_text())
    found = arrows_of(source, rooms)
    wrong = [f"{file}: {a} may not include {b}" for (a, b), file in found.items() if (a, b) not in allowed]
    wrong += [f"{a}: {b} is allowed, but nothing includes it" for a, b in sorted(allowed - set(found))]
    wrong += [f"{a}: {b} stands below it in the list: a room may include rooms above it only" for a, b in sorted(allowed)
              if b not in rooms or rooms.index(b) > rooms.index(a)]
    print("\n".join(wrong) or f"{len(found)} arrows between {len(rooms)} rooms, all allowed")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
