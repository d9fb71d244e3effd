"""The copy of the tree that holds the mutants, and its build."""
import json
import pathlib
import re
import shutil
import subprocess

from .schemata import SWITCH, numbered

MARK = re.compile(r"plumb_mutant_(\d+):\d+(?::\d+)?")


def write_if_new(path, text):
    """Writes a file only if it is not there as it should be: what did not change is not built again."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_bytes() != text:
        path.write_bytes(text)


class Workshop:
    def __init__(self, root, place, jobs, skip=()):
        self.root, self.place, self.jobs, self.skip = root, place, jobs, skip
        self.build = place / "build/release"

    def files(self):
        """What git knows or would take."""
        listed = subprocess.run(["git", "-C", self.root, "ls-files", "-co", "--exclude-standard", "-z"], check=True,
                                capture_output=True, text=True).stdout
        return [f for f in listed.split("\0") if f and (self.root / f).is_file()]

    def write(self, mutants):
        """Copies the tree and puts the mutants {number: mutant} in."""
        switch = self.place / "plumb_mutant.hpp"
        write_if_new(switch, SWITCH.encode())
        by_file = {}
        for number, m in mutants.items():
            by_file.setdefault(m.file, {})[number] = m
        wanted = self.files()
        for file in wanted:
            text = (self.root / file).read_bytes()
            if file in by_file:
                text = numbered(text.decode(), by_file[file], switch).encode()
            write_if_new(self.place / file, text)
            shutil.copymode(self.root / file, self.place / file)
        self.remove_others(set(wanted))

    def remove_others(self, wanted):
        for folder in ("lib", "mms", "oned", "reports", "tests", "verification"):
            for path in (self.place / folder).rglob("*"):
                if path.is_file() and str(path.relative_to(self.place)) not in wanted and "__pycache__" not in path.parts:
                    path.unlink()

    def configure(self):
        """As the release build, in a folder of the same depth: what holds no mutant comes from ccache."""
        if not (self.build / "build.ninja").exists():
            launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
            subprocess.run(["cmake", "--preset", "release", *launcher], cwd=self.place, check=True, stdout=subprocess.DEVNULL)

    def targets(self):
        rooms = {p.relative_to(self.root / "tests").parts for p in (self.root / "tests").rglob("*_test.cpp")}
        names = {"tests_" + "_".join(r[:4] if r[:3] == ("lib", "schemes", "tlsph") else r[:2] if r[0] == "lib" else r[:1]) for r in rooms}
        return [n for n in [*sorted(names - {"tests_fuzz"}), "studies", "plumb"] if n not in self.skip]

    def programs(self):
        """Test programs, relative to the build folder."""
        return [f"verification/studies/{n}" if n == "studies" else f"tests/{n}" for n in self.targets() if n != "plumb"]

    def make(self, mutants, tell):
        """Builds; mutants that do not compile are taken out until the rest does. Returns those that were left out, which are
        written down: a later call does not try them again."""
        listed = self.place / "not_compiled.json"
        names = set(json.loads(listed.read_text())) if listed.exists() else set()
        left_out = {n: m for n, m in mutants.items() if m.name() in names}
        while True:
            self.write({n: m for n, m in mutants.items() if n not in left_out})
            self.configure()
            done = subprocess.run(["ninja", "-C", self.build, "-k", "0", "-j", str(self.jobs), *self.targets()],
                                  capture_output=True, text=True, errors="replace")
            if done.returncode == 0:
                return left_out
            if done.returncode < 0 or "interrupted by user" in done.stdout:
                raise RuntimeError("the build of the copy was stopped; the same call goes on with it")
            wrong = culprits(done.stdout, {n: m for n, m in mutants.items() if n not in left_out})
            if not wrong:
                (self.place / "build.log").write_text(done.stdout + done.stderr)
                raise RuntimeError(f"the copy does not build, and no mutant is to blame: see {self.place / 'build.log'}")
            left_out |= {n: mutants[n] for n in wrong}
            listed.write_text(json.dumps(sorted(names | {m.name() for m in left_out.values()}), indent=1) + "\n")
            tell(f"{len(wrong)} mutants do not compile and are left out: " + ", ".join(f"{n} {mutants[n].file}" for n in sorted(wrong)))


def culprits(log, mutants):
    """Mutants that the errors of a build name: by their own lines, else those of the files named that lost a `constexpr`, else all
    of the files named."""
    found = set()
    for block in re.split(r"^(?=\[\d+/\d+\]|FAILED: )", log, flags=re.M):
        if not block.startswith("FAILED: "):
            continue
        errors = {int(m[1]) for line in block.splitlines() if "error:" in line for m in MARK.finditer(line)}
        mentioned = errors or {int(n) for n in MARK.findall(block)}
        mentioned &= mutants.keys()
        if not mentioned:
            inside = {n for n, m in mutants.items() if re.search(rf"\b{re.escape(m.file)}:\d+", block)}
            inside = inside or {n for n, m in mutants.items() if m.file in block}
            mentioned = {n for n in inside if mutants[n].region.constexpr >= 0} or inside
        found |= mentioned
    return found


def read_state(place):
    path = place / "state.json"
    return json.loads(path.read_text()) if path.exists() else {}


def write_state(place, state):
    pathlib.Path(place / "state.json").write_text(json.dumps(state, indent=1) + "\n")
