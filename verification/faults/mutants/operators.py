"""Mutation operators: small slips of the pen in C++ sources. Each looks at the tokens of a region and yields edits."""
import dataclasses
import re

from .source import CLOSING, OPENING, closing

PARTNERS = {"a": "b", "b": "a", "i": "j", "j": "i", "k": "l", "p": "q", "row": "lane", "begin": "end", "lower": "upper",
            "upper": "lower", "first": "second", "second": "first"}
TURNED = {"<": ["<=", ">"], "<=": ["<", ">="], ">": [">=", "<"], ">=": [">", "<="], "==": ["!="], "!=": ["=="],
          "&&": ["||"], "||": ["&&"]}
EXTREMES = {"min": "max", "max": "min", "cwiseMin": "cwiseMax", "cwiseMax": "cwiseMin", "minCoeff": "maxCoeff",
            "maxCoeff": "minCoeff", "floor": "ceil", "ceil": "floor"}
KEY = re.compile(r'"[A-Za-z_][\w .-]*"')
READERS = {"at", "value", "contains", "text", "number", "find", "get", "column", "count", "optional", "read"}
KEYWORDS = {"if", "for", "while", "switch", "return", "sizeof", "decltype", "catch", "static_assert", "alignas", "noexcept"}
SILENT = {"throw", "static_assert", "assert", "reserve", "case", "template", "using"}  # what follows is no value of a result


@dataclasses.dataclass(frozen=True)
class Edit:
    operator: str
    start: int  # characters start..end - 1 of the file become `new`
    end: int
    new: str


def edits(text, tokens, region):
    """All edits of a region, in order."""
    mute = silent(tokens, region)
    found = []
    for operator in (LITERAL if region.kind == "literal" else ALL):
        found += [e for e, n in operator(text, tokens, region) if n not in mute]
    return found


def silent(tokens, region):
    """Tokens whose change nobody is meant to see: messages of errors, reserved memory, assertions, arguments of templates."""
    mute = set()
    for n in range(region.first, region.last):
        word = tokens[n].text
        if word in SILENT:
            end = n
            while end < region.last and tokens[end].text not in (";", "}") and not (word == "reserve" and tokens[end].text == ")"):
                end = closing(tokens, end) if tokens[end].text in "({" and word != "reserve" else end
                end += 1
            mute.update(range(n, end + 1))
        if tokens[n].text == "<" and not tokens[n].apart:  # State<2>
            mute.update(range(n, next((m for m in range(n, region.last) if tokens[m].text in (">", ">>", ";")), n)))
    return mute


def sign(text, tokens, region):
    """+ for -, - dropped."""
    swapped = {"+": "-", "-": "+", "+=": "-=", "-=": "+="}
    for n in range(region.first, region.last):
        t = tokens[n]
        beside = (tokens[n - 1], tokens[n + 1]) if n + 1 < len(tokens) else ()
        if t.text not in swapped or any(b.kind in ("string", "char") for b in beside):
            continue
        if t.apart:
            yield Edit("sign", t.start, t.end, swapped[t.text]), n
        elif t.text == "-" and (tokens[n - 1].text == "return" or
                                (tokens[n - 1].kind == "operator" and tokens[n - 1].text not in CLOSING)):
            yield Edit("sign", t.start, t.end, ""), n


def factor(text, tokens, region):
    """A returned or assigned value twice or half as large."""
    starts = [n for n in range(region.first, region.last) if tokens[n].text in ("return", "=", "+=", "-=") or n == region.first - 1]
    if region.kind == "expression":
        starts = [region.first - 1]
    for n in starts:
        end, depth = n + 1, 0
        while end < region.last and (depth or tokens[end].text not in (";", ",", ")")):
            depth += (tokens[end].text in OPENING) - (tokens[end].text in CLOSING)
            end += 1
        inner = tokens[n + 1:end]
        if not inner or inner[0].text in ("{", "[", "true", "false", "nullptr", "std", "fmt", "*", "&", "new"):
            continue
        if len(inner) == 1 and inner[0].text in ("0", "0.0"):
            continue
        if any(t.kind in ("string", "char") or t.text in ("&&", "||", "==", "!=", "{", "!", "?") for t in inner):
            continue
        if any(t.apart and t.text in ("<", ">", "<=", ">=") for t in inner):
            continue
        whole = text[inner[0].start:inner[-1].end]
        for by in ("2", "0.5"):
            yield Edit("factor " + by, inner[0].start, inner[-1].end, f"{by} * ({whole})"), n


def index(text, tokens, region):
    """One index for another: [i] for [j], lower for upper."""
    words = {t.text for t in tokens[region.first:region.last]}
    for n in range(region.first, region.last):
        t = tokens[n]
        partner = PARTNERS.get(t.text)
        if not partner or n + 1 >= len(tokens):
            continue
        inside = tokens[n - 1].text in "[(," and tokens[n + 1].text in ")],"
        member = tokens[n - 1].text in (".", "->")
        if (inside and partner in words) or (member and len(t.text) > 1 and partner in words):
            yield Edit("index", t.start, t.end, partner), n


def off_by_one(text, tokens, region):
    """A whole number plus one."""
    for n in range(region.first, region.last):
        t = tokens[n]
        if t.kind == "number" and re.fullmatch(r"\d+", t.text) and tokens[n - 1].text != "<":
            yield Edit("off by one", t.start, t.end, str(int(t.text) + 1)), n


def constant(text, tokens, region):
    """A real number a tenth larger; limits of round-off are left alone."""
    for n in range(region.first, region.last):
        t = tokens[n]
        if t.kind != "number" or not re.fullmatch(r"(\d+\.\d*|\.\d+|\d+)(e[+-]?\d+)?", t.text) or t.text.isdigit():
            continue
        value = float(t.text)
        if region.kind == "literal" or value == 0 or value > 1e-6:
            yield Edit("constant", t.start, t.end, f"{1.1 * value if value else 0.1!r}"), n


def dropped(text, tokens, region):
    """A term of a sum, or a statement that adds or calls, left out."""
    for n in range(region.first, region.last):
        t = tokens[n]
        if t.text in "+-" and t.apart and tokens[n + 1].kind != "string" and tokens[n - 1].kind != "string":
            end = n + 1
            while end < region.last and not (tokens[end].text in CLOSING + ";,?:" or
                                             (tokens[end].apart and tokens[end].text in "+ - < > <= >= == != && ||".split())):
                end = closing(tokens, end) + 1 if tokens[end].text in OPENING else end + 1
            yield Edit("term dropped", t.start, tokens[end - 1].end, ""), n
        if region.kind == "body" and (n == region.first or tokens[n - 1].text in ";{}") and t.kind == "word":
            end = n
            while end < region.last and tokens[end].text not in (";", "=", "{", "return", "}"):
                end = closing(tokens, end) + 1 if tokens[end].text in "([" else end + 1
            if end < region.last and tokens[end].text == ";" and end > n + 1 and t.text not in KEYWORDS | {"else"} and not any(
                    x.text in SILENT for x in tokens[n:end]) and (
                    any(x.text in ("+=", "-=", "*=", "/=") for x in tokens[n:end]) or
                    (tokens[end - 1].text == ")" and tokens[n + 1].text in ("(", ".", "->", "::"))):
                yield Edit("statement dropped", t.start, tokens[end - 1].end, ""), n


def arguments(text, tokens, region):
    """The two arguments of a call exchanged."""
    for n in range(region.first + 1, region.last):
        if tokens[n].text != "(" or tokens[n - 1].kind != "word" or tokens[n - 1].text in KEYWORDS:
            continue
        end = closing(tokens, n)
        commas, m = [], n + 1
        while m < end:
            if tokens[m].text == ",":
                commas.append(m)
            m = closing(tokens, m) + 1 if tokens[m].text in OPENING else m + 1
        if len(commas) != 1 or any(t.text == "const" or t.text == "auto" or t.kind == "string" for t in tokens[n:end]):
            continue
        one = text[tokens[n + 1].start:tokens[commas[0] - 1].end]
        two = text[tokens[commas[0] + 1].start:tokens[end - 1].end]
        if one != two and "<" not in one + two:
            yield Edit("arguments", tokens[n + 1].start, tokens[end - 1].end, f"{two}, {one}"), n


def comparison(text, tokens, region):
    """A comparison turned or its bound taken in, all for any, least for largest."""
    for n in range(region.first, region.last):
        t = tokens[n]
        if t.apart and t.text in TURNED:
            for new in TURNED[t.text]:
                yield Edit("comparison", t.start, t.end, new), n
        if t.text in EXTREMES and tokens[n - 1].text in ("::", ".") and tokens[n + 1].text == "(":
            yield Edit("comparison", t.start, t.end, EXTREMES[t.text]), n


def key(text, tokens, region):
    """The name of a column, a key or a series exchanged for another of the same region, or misspelt."""
    places = []
    for n in range(region.first, region.last):
        t, before = tokens[n], tokens[n - 1].text
        reader = before == "[" or (before == "(" and tokens[n - 2].text in READERS)
        if t.kind == "string" and KEY.fullmatch(t.text) and (reader or (before == "{" and tokens[n + 1].text in ",}")):
            places.append(n)
    names = sorted({tokens[n].text for n in places})
    for n in places:
        t = tokens[n]
        other = names[(names.index(t.text) + 1) % len(names)]
        yield Edit("key", t.start, t.end, other if other != t.text else t.text[:-1] + '_"'), n


LITERAL = [off_by_one, constant, key]
ALL = [sign, factor, index, off_by_one, constant, dropped, arguments, comparison, key]
