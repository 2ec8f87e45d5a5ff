#!/usr/bin/env python3
"""Runs clang-tidy 14 on what has changed, a few minutes at most.

  tidy.py BUILD_DIR

Compares with $CI_BASE, else with where the branch left origin/main, else with the commit before. Sources that have
changed come first, then those of the same folder that include a header that has changed. Of more than LIMIT, the others
are left out and counted.
"""
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys

LIMIT = 40


def git(*words):
    done = subprocess.run(["git", *words], capture_output=True, text=True)
    return done.stdout.split("\n")[:-1] if done.returncode == 0 else []


def base():
    if os.environ.get("CI_BASE"):
        return os.environ["CI_BASE"]
    head = git("rev-parse", "HEAD")
    fork = git("merge-base", "origin/main", "HEAD")
    return (fork if fork != head else [])[:1] or git("rev-parse", "--verify", "HEAD~1")


def changed():
    found = base()
    if not found:  # a clone of one commit
        return git("show", "--name-only", "--format=", "--diff-filter=d", "HEAD")
    commit = found if isinstance(found, str) else found[0]
    if not git("rev-parse", "--verify", f"{commit}^{{commit}}"):
        sys.exit(f"clang-tidy: there is no commit {commit}")
    return git("diff", "--name-only", "--diff-filter=d", commit)


def includers(header, sources):
    """The sources of the header's folder, or of the one above detail/, that include it."""
    folder = header.parent.parent if header.parent.name == "detail" else header.parent
    name = str(header.relative_to("packages")) if header.parts[0] == "packages" else header.name
    return [each for each in sources if folder in each.parents and
            any(line.startswith("#include") and name in line for line in each.read_text().splitlines())]


def main():
    build = pathlib.Path(sys.argv[1])
    root = pathlib.Path.cwd()
    compiled = [pathlib.Path(each["file"]) for each in json.loads((build / "compile_commands.json").read_text())]
    sources = sorted({each.relative_to(root) for each in compiled if root in each.parents and build not in each.parents})
    files = [pathlib.Path(each) for each in changed()]
    chosen = [each for each in sources if each in files]
    for header in (each for each in files if each.suffix == ".hpp"):
        chosen += [each for each in includers(header, sources) if each not in chosen]
    if len(chosen) > LIMIT:
        print(f"clang-tidy: {len(chosen) - LIMIT} of {len(chosen)} sources are left out, the limit is {LIMIT}")
    chosen = chosen[:LIMIT]

    def tidy(source):
        return subprocess.run(["clang-tidy-14", "-p", build, "--quiet", source], capture_output=True, text=True)

    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        failed = [each for each in pool.map(tidy, chosen) if each.returncode != 0]
    for each in failed:
        print(each.stdout or each.stderr)
    print(f"clang-tidy: {len(chosen)} sources, {len(failed)} with findings")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
