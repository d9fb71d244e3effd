"""Reads C++ sources as clang-format leaves them: tokens, and the regions in which a mutant can stand.

A region is the smallest piece that can be written twice and chosen at run time: the body of a function, an initialiser that is one
expression, or one literal of a braced table. What the preprocessor reads, comments, types and template arguments are no region.
"""
import dataclasses
import re

TOKEN = re.compile(r"""
  (?P<comment>//[^\n]*|/\*.*?\*/) | (?P<directive>^[ \t]*\#(?:[^\n\\]|\\\n|\\.)*) | (?P<space>\s+)
| (?P<string>(?:u8|u|U|L)?R"(?P<mark>[^()\s\\]*)\(.*?\)(?P=mark)"|"(?:[^"\\\n]|\\.)*") | (?P<char>'(?:[^'\\\n]|\\.)+')
| (?P<number>\.?\d(?:'?[\w.]|(?<=[eEpP])[+-])*) | (?P<word>[A-Za-z_]\w*)
| (?P<operator><=>|<<=|>>=|->\*|\.\.\.|::|->|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|.)
""", re.X | re.S | re.M)
OPENING, CLOSING = "([{", ")]}"


@dataclasses.dataclass(frozen=True)
class Token:
    kind: str
    text: str
    start: int
    end: int
    apart: bool  # white space before and after: in formatted code a binary operator, never a bracket of a template


@dataclasses.dataclass(frozen=True)
class Region:
    kind: str  # body, expression, literal
    first: int  # tokens first..last - 1, without the braces of a body
    last: int
    constexpr: int  # the token `constexpr` of the declaration, -1 if it has none
    function: bool


def read_tokens(text):
    found = [m for m in TOKEN.finditer(text)]
    tokens = []
    for n, match in enumerate(found):
        if match.lastgroup in ("comment", "directive", "space") or match["comment"] or match["directive"]:
            continue
        before = n > 0 and found[n - 1]["space"] is not None
        after = n + 1 < len(found) and (found[n + 1]["space"] is not None)
        kind = next(k for k in ("string", "char", "number", "word", "operator") if match[k] is not None)
        tokens.append(Token(kind, match[0], match.start(), match.end(), before and after))
    return tokens


def closing(tokens, at):
    """The token that closes the bracket at `at`; the last one if there is none."""
    depth = 0
    for n in range(at, len(tokens)):
        depth += (tokens[n].text in OPENING) - (tokens[n].text in CLOSING)
        if depth == 0:
            return n
    return len(tokens) - 1


def after_template(tokens, first, last):
    """First token behind `template <..>`."""
    while first < last and tokens[first].text == "template":
        depth = 0
        for n in range(first + 1, last):
            depth += {"<": 1, ">": -1, ">>": -2}.get(tokens[n].text, 0)
            if depth <= 0:
                break
        first = n + 1
    return first


def read_regions(tokens):
    """Every region of a file."""
    regions, n, head = [], 0, 0
    while n < len(tokens):
        text = tokens[n].text
        if text in "([":
            n = closing(tokens, n)
        elif text == ":" and tokens[n - 1].text in ("public", "private", "protected"):
            head = n + 1
        elif text == "}":
            head = n + 1
        elif text == ";":
            regions += initialisers(tokens, head, n)
            head = n + 1
        elif text == "{":
            kind = scope_of(tokens, after_template(tokens, head, n), n)
            if kind == "function":
                last = closing(tokens, n)
                constexpr = constexpr_of(tokens, head, n)
                regions += member_initialisers(tokens, head, n)
                regions.append(Region("body", n + 1, last, constexpr, True))
                n, head = last, last + 1
            elif kind == "scope":
                head = n + 1
            else:
                n = closing(tokens, n)
        n += 1
    return regions


def scope_of(tokens, first, brace):
    """What the brace opens: "scope" (namespace, class), "function" or "values"."""
    words = [t.text for t in tokens[first:brace]]
    if not words or "enum" in words:
        return "values"
    if words[0] in ("namespace", "extern") or (words[0] == "inline" and "namespace" in words):
        return "scope"
    outer = outer_words(words)
    if "operator" not in outer and "=" in outer:
        return "values"
    if "(" in outer:
        listed = ":" in outer and outer[outer.index(":") - 1] == ")"
        return "values" if listed and tokens[brace - 1].text not in (")", "}") else "function"
    return "scope" if {"class", "struct", "union"} & set(outer) else "values"


def outer_words(words):
    """Words outside brackets, each bracket pair as its two ends."""
    depth, outer = 0, []
    for w in words:
        depth -= w in CLOSING
        if depth == 0:
            outer.append(w)
        depth += w in OPENING
    return outer


def constexpr_of(tokens, first, last):
    first = after_template(tokens, first, last)
    return next((n for n in range(first, last) if tokens[n].text == "constexpr"), -1)


def initialisers(tokens, head, last):
    """Regions of a declaration outside functions: `= expression` or the literals of `{..}`."""
    first = after_template(tokens, head, last)
    if first >= last or tokens[first].text in ("using", "typedef", "friend", "static_assert", "concept", "return", "extern", "enum"):
        return []
    constexpr, n = constexpr_of(tokens, head, last), first
    while n < last and tokens[n].text not in ("=", "{"):
        if tokens[n].text == "operator":
            return []
        n = closing(tokens, n) + 1 if tokens[n].text in "([" else n + 1
    if n >= last or (tokens[n].text == "=" and tokens[n - 1].text in (")", "const", "noexcept")):
        return []
    if tokens[n].text == "=" and not any(t.text in ("{", "[") for t in tokens[n + 1:last]):
        return [Region("expression", n + 1, last, constexpr, False)]
    return literals(tokens, n + 1, last, constexpr, False)


def literals(tokens, first, last, constexpr, function):
    return [Region("literal", n, n + 1, constexpr, function) for n in range(first, last)
            if tokens[n].kind in ("number", "string")]


def member_initialisers(tokens, head, brace):
    """`: lame(e.lame()), shear(..)` of a constructor."""
    found, n, listed = [], head, False
    while n < brace:
        if tokens[n].text in OPENING:
            end = closing(tokens, n)
            if listed and end > n + 1 and not any(t.text == "," or t.text in "{[" for t in tokens[n + 1:end]):
                found.append(Region("expression", n + 1, end, constexpr_of(tokens, head, brace), True))
            elif listed:
                found += literals(tokens, n + 1, end, constexpr_of(tokens, head, brace), True)
            n = end
        elif tokens[n].text == ":" and tokens[n - 1].text == ")":
            listed = True
        n += 1
    return found
