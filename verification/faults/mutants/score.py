"""The score of a sample: the share of mutants that a test sees, with its interval, in all and by folder."""
import json
import math
import tomllib


def wilson(killed, number, z=1.959964):
    """Wilson's score interval of a share, 95 %."""
    if number == 0:
        return None
    share, square = killed / number, z * z
    middle = (share + square / (2 * number)) / (1 + square / number)
    half = z / (1 + square / number) * math.sqrt(share * (1 - share) / number + square / (4 * number * number))
    return [round(max(0.0, middle - half), 4), round(min(1.0, middle + half), 4)]


def folder_of(file):
    """lib/<room>, lib/schemes/tlsph/<room>, and the first folder of the others."""
    parts = file.split("/")
    if parts[0] != "lib":
        return parts[0]
    return "/".join(parts[:4] if parts[1:3] == ["schemes", "tlsph"] else parts[:2])


def equivalents(path):
    """{(file, before, after): reason}"""
    rows = tomllib.loads(path.read_text()).get("equivalent", []) if path.exists() else []
    return {(r["file"], r["before"], r["after"]): r["reason"] for r in rows}


def line(name, rows):
    """Counts of one folder. The share is of those that a test could see; `at_first` is the share before tests were written for what
    the sample had shown."""
    count = {s: sum(r["state"] == s for r in rows) for s in ("killed", "alive", "equivalent", "not compiled")}
    judged = count["killed"] + count["alive"]
    first = sum(r["state"] == "killed" and r.get("first", "killed") == "killed" for r in rows)
    return {"folder": name, "sampled": len(rows), "killed": count["killed"], "alive": count["alive"], "equivalent": count["equivalent"],
            "not_compiled": count["not compiled"], "share": share(count["killed"], judged), "interval": wilson(count["killed"], judged),
            "killed_at_first": first, "share_at_first": share(first, judged), "interval_at_first": wilson(first, judged)}


def share(killed, judged):
    return round(killed / judged, 4) if judged else None


def score(rows, about):
    """All of it, as sampled.json holds it."""
    folders = sorted({folder_of(r["file"]) for r in rows})
    return about | {"all": line("all", rows), "folders": [line(f, [r for r in rows if folder_of(r["file"]) == f]) for f in folders],
                    "mutants": rows}


def merged(path, about, rows, sample):
    """The rows with those that an earlier call judged of the same sample {number: mutant}; what has changed since is left out.
    A sample begins with every smaller one of its seed."""
    known, numbers = {}, {(m.file, m.before, m.after): n for n, m in sample.items()}
    if path.exists():
        stored = json.loads(path.read_text())
        if all(stored.get(k) == v for k, v in about.items() if k in ("seed", "drawn_from")):
            named = [(numbers.get(identity(r)), r) for r in stored["mutants"]]
            known = {n: r | {"number": n, "line": sample[n].line} for n, r in named if n}
    first = {n: r.get("first", r["state"]) for n, r in known.items()}
    known |= {r["number"]: r | {"first": first.get(r["number"], r["state"])} for r in rows}
    return [known[n] for n in sorted(known)]


def identity(row):
    return row["file"], row["before"], row["after"]


def unseen(path, sample):
    """Numbers of those that the stored score calls alive."""
    stored = json.loads(path.read_text())["mutants"] if path.exists() else []
    alive = {identity(r) for r in stored if r["state"] == "alive"}
    return {n for n, m in sample.items() if (m.file, m.before, m.after) in alive}
