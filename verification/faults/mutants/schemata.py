"""Chooses mutants and writes them into a copy of the sources, each beside the original behind a switch that is read at run time."""
import collections
import dataclasses
import hashlib

from .operators import edits
from .source import Region, read_regions, read_tokens

SWITCH = """#pragma once
#include <fcntl.h>
#include <sys/mman.h>

#include <cstdlib>

// Written by verification/faults/sample. PLUMB_MUTANT=n: mutant n lives. PLUMB_MUTANTS_SEEN=file: a byte is set for each mutant
// whose place is reached; the file is shared by all processes of a test and outlives those that are killed.
inline int plumb_mutant_alive = 0;
inline unsigned char plumb_mutants_nowhere[65536];
inline unsigned char* plumb_mutants_seen = plumb_mutants_nowhere;

__attribute__((constructor(101))) static void plumb_mutant_read() {
  if (const char* number = std::getenv("PLUMB_MUTANT")) plumb_mutant_alive = std::atoi(number);
  const char* file = std::getenv("PLUMB_MUTANTS_SEEN");
  const int at = file && plumb_mutants_seen == plumb_mutants_nowhere ? open(file, O_RDWR | O_CLOEXEC) : -1;
  if (at < 0) return;
  void* seen = mmap(nullptr, sizeof plumb_mutants_nowhere, PROT_READ | PROT_WRITE, MAP_SHARED, at, 0);
  if (seen != MAP_FAILED) plumb_mutants_seen = static_cast<unsigned char*>(seen);
}

inline bool plumb_mutant(int number) {
  if (!plumb_mutants_seen[number]) plumb_mutants_seen[number] = 1;
  return plumb_mutant_alive == number;
}
"""

# Lines that bear another name look like those of a header, in which lambdas must not hold what a namespace without name has.
QUIET = '#pragma GCC diagnostic ignored "-Wsubobject-linkage"\n'


@dataclasses.dataclass(frozen=True)
class Mutant:
    file: str
    operator: str
    start: int
    end: int
    new: str
    line: int
    before: str  # the line as it is, and as it would be
    after: str
    region: Region

    def name(self):
        return f"{self.file}:{self.line} {self.operator}: {self.before} -> {self.after}"


def mutants_of(file, text):
    """Every mutant of one file."""
    tokens = read_tokens(text)
    found = []
    for region in read_regions(tokens):
        if region.first >= region.last:
            continue
        for e in edits(text, tokens, region):
            begin = text.rfind("\n", 0, e.start) + 1
            end = (text + "\n").find("\n", e.end)
            after = " ".join((text[begin:e.start] + e.new + text[e.end:end]).split())
            found.append(Mutant(file, e.operator, e.start, e.end, e.new, text.count("\n", 0, e.start) + 1,
                                " ".join(text[begin:end].split()), after, region))
    return found


def draw(candidates, count, seed):
    """A random order of the mutants, by places first: a place that many operators can change counts once. The order depends on the
    text of each place and on nothing else, so that a sample stays what it is when other lines change."""
    places, seen, order = {}, collections.Counter(), {}
    for m in sorted(candidates, key=lambda m: (m.file, m.start, m.operator, m.new)):
        places.setdefault((m.file, m.start), []).append(m)
    for place in sorted(places):
        name = (place[0], places[place][0].before)
        order[place] = hashlib.sha256(f"{seed} {name} {seen[name]}".encode()).digest()
        seen[name] += 1
    return [places[p][order[p][-1] % len(places[p])] for p in sorted(places, key=order.get)][:count]


def numbered(text, mutants, switch):
    """The file with its mutants in it: {number: mutant}."""
    tokens = read_tokens(text)
    regions = {}
    for number, m in mutants.items():
        regions.setdefault(m.region, []).append((number, m))
    pieces = []
    for region, members in regions.items():
        first = tokens[region.first].start
        last = tokens[region.last].start if region.kind == "body" else tokens[region.last - 1].end
        pieces.append((first, last, chosen_at_run_time(text, first, last, region, members)))
    dropped = {m.region.constexpr: m.region.function for m in mutants.values() if m.region.constexpr >= 0}
    for at, function in dropped.items():
        already = function or tokens[at + 1].text == "const"
        pieces.append((tokens[at].start, tokens[at].end, "inline" if already else "inline const"))
    for first, last, new in sorted(pieces, reverse=True):
        text = text[:first] + new + text[last:]
    return f'{QUIET}#include "{switch}"\n#line 1 "{next(iter(mutants.values())).file}"\n' + text


def chosen_at_run_time(text, first, last, region, members):
    """The piece of text, and every mutant of it. Lines of a mutant are called after it, so that compilers name the mutant."""
    file, line = members[0][1].file, text.count("\n", 0, first) + 1

    def mark(name, at):
        return f'\n#line {at} "{name}"\n'

    parts = []
    for number, m in members:
        mutated = text[first:m.start] + m.new + text[m.end:last]
        if region.kind == "body":
            parts.append(f"if (plumb_mutant({number})) {{{mark(f'plumb_mutant_{number}', line)}{mutated}{mark(file, line)}}} else ")
        else:
            parts.append(f"plumb_mutant({number}) ? {mark(f'plumb_mutant_{number}', line)}({mutated}){mark(file, line)} : ")
    original = text[first:last]
    if region.kind == "body":
        return "".join(parts) + "{" + mark(file, line) + original + "}" + mark(file, text.count("\n", 0, last) + 1)
    return "(" + "".join(parts) + "(" + original + "))"
