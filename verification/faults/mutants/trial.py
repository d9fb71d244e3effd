"""Runs the tests: once to see which places each test reaches, then for every mutant those that reach it, quick ones first."""
import concurrent.futures
import contextlib
import dataclasses
import os
import pathlib
import re
import subprocess
import tempfile
import time

QUICK = 0.5  # seconds: tests below it run together in one process
SEEN = 65536


@dataclasses.dataclass
class Test:
    program: str
    name: str
    seconds: float = 0.0
    reaches: frozenset = frozenset()


def list_tests(build, program):
    """Names of the tests of a program, without those marked as long."""
    if program.endswith("studies"):
        listed = subprocess.run([build / program, "~[long]", "--list-test-names-only"], capture_output=True, text=True).stdout
        return [Test(program, line.strip()) for line in listed.splitlines() if line.strip()]
    listed = subprocess.run([build / program, "--gtest_list_tests"], capture_output=True, text=True, check=True).stdout
    found, suite = [], ""
    for line in listed.splitlines():
        name = line.split("#")[0].rstrip()
        if not name.startswith(" "):
            suite = name
        elif "Long" not in suite + name and "DISABLED" not in name:
            found.append(Test(program, suite + name.strip()))
    return found


def command(build, program, names):
    if program.endswith("studies"):
        return [build / program, "-a", *(re.sub(r"([\\,\[\]])", r"\\\1", n) for n in names)]
    return [build / program, "--gtest_fail_fast", "--gtest_brief=1", "--gtest_filter=" + ":".join(names)]


def run(build, program, names, limit, **environment):
    """None if all passed, else what failed."""
    with tempfile.TemporaryDirectory(prefix="plumb_sample_", ignore_cleanup_errors=True) as folder:
        try:
            process = subprocess.Popen(command(build, program, names), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                       errors="replace", cwd=folder, start_new_session=True, stdin=subprocess.DEVNULL,
                                       env=os.environ | {"OMP_WAIT_POLICY": "passive", "TMPDIR": folder} | environment)
            output, _ = process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, 9)
            process.communicate()
            return f"{pathlib.Path(program).name}: {names[0] if len(names) == 1 else 'one of its tests'} takes longer than {limit:.0f} s"
    if process.returncode == 0:
        return None
    failed = re.findall(r"\[  FAILED  \] (\S+?)(?:,| \()", output)
    return f"{pathlib.Path(program).name}: {failed[0] if failed else names[0] if len(names) == 1 else 'crash'}"


def survey(build, tests, jobs, tell, most):
    """Times every test and sees which mutants it reaches. Those that fail, or take longer than `most` seconds, are not used."""
    def one(test):
        with tempfile.NamedTemporaryFile(prefix="plumb_seen_") as file:
            file.write(bytes(SEEN))
            file.flush()
            start = time.monotonic()
            failure = run(build, test.program, [test.name], most, PLUMB_MUTANTS_SEEN=file.name)
            test.seconds = time.monotonic() - start
            test.reaches = frozenset(n for n, b in enumerate(pathlib.Path(file.name).read_bytes()) if b)
        return failure

    used = []
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for test, failure in zip(tests, pool.map(one, tests)):
            if failure:
                tell(f"not used, fails or is too slow without a mutant: {failure}")
            else:
                used.append(test)
    return used


def first_red(build, number, tests, budget):
    """The first test that a mutant turns red: quick tests by program, then the others by time, until the budget is spent."""
    reaching = sorted((t for t in tests if number in t.reaches), key=lambda t: t.seconds)
    quick, start = {}, time.monotonic()
    for t in reaching:
        if t.seconds < QUICK:
            quick.setdefault(t.program, []).append(t)
    groups = sorted(quick.values(), key=lambda g: sum(t.seconds for t in g)) + [[t] for t in reaching if t.seconds >= QUICK]
    for done, group in enumerate(groups):
        if time.monotonic() - start > budget:
            return None, f"alive after {budget} s, {sum(map(len, groups[done:]))} tests not run"
        usual = sum(t.seconds for t in group)
        failure = run(build, group[0].program, [t.name for t in group], 10 + 10 * usual, PLUMB_MUTANT=str(number))
        if failure:
            return failure, ""
    return None, f"{len(reaching)} tests reach it" if reaching else "no test reaches it"
