"""Runs docs/tutorial.md as a script: writes its files, runs its commands, compares their output.

    tutorial_test.py TUTORIAL.md

`touchstone` must be on the path. A block "```language NAME" is the file NAME. A block "```console"
has commands, lines that begin with "$ ", each followed by its output. "…" stands for any part of
a line, and a line "…" for any lines; empty lines do not count. A last line "(exit code N)" is the
exit code, otherwise 0.
"""

import pathlib
import re
import subprocess
import sys
import tempfile


def blocks(text):
    """Yields the info string and the lines of each block, and the number of its first line."""
    lines = text.split("\n")
    i = 0
    while i < len(lines):
        if lines[i].startswith("```"):
            end = lines.index("```", i + 1)
            yield lines[i][3:].strip(), lines[i + 1 : end], i + 2
            i = end
        i += 1


def commands(lines, first):
    """Yields each command of a console block with its expected output and exit code."""
    found = []
    for number, line in enumerate(lines, first):
        if line.startswith("$ "):
            found.append((line[2:], number, []))
        else:
            found[-1][2].append(line)
    for command, number, expected in found:
        code = 0
        if expected and (stated := re.fullmatch(r"\(exit code (\d+)\)", expected[-1])):
            code = int(stated[1])
            expected.pop()
        yield command, number, expected, code


def matches(expected, line):
    pattern = ".*".join(re.escape(part.strip(" ")) for part in expected.split("…"))
    return re.fullmatch(pattern, line.strip(" ")) is not None


def first_missing(expected, output):
    """Returns the first expected line that the output does not have in its place, or None."""
    output = [line for line in output if line.strip()]
    at = 0
    anywhere = False
    for line in expected:
        if not line.strip():
            continue
        if line == "…":
            anywhere = True
            continue
        reach = range(at, len(output)) if anywhere else range(at, min(at + 1, len(output)))
        found = next((i for i in reach if matches(line, output[i])), None)
        if found is None:
            return line
        at, anywhere = found + 1, False
    return None if anywhere or at == len(output) else "(the end of the output)"


def main():
    tutorial = pathlib.Path(sys.argv[1]).resolve()
    wrong = ran = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for info, lines, first in blocks(tutorial.read_text(encoding="utf-8")):
            words = info.split()
            if len(words) == 2:
                path = folder / words[1]
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text("\n".join(lines) + "\n", encoding="utf-8")
            elif words == ["console"]:
                for command, number, expected, code in commands(lines, first):
                    ran += 1
                    done = subprocess.run(
                        ["bash", "-c", command], cwd=folder, text=True, stdin=subprocess.DEVNULL,
                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=600)
                    missing = first_missing(expected, done.stdout.split("\n"))
                    if done.returncode == code and missing is None:
                        continue
                    wrong += 1
                    print(f"{tutorial}:{number}: $ {command}\n"
                          f"  exit code {done.returncode}; expected {code}\n"
                          f"  expected line: {missing}\n  output:\n{done.stdout}")
    print(f"{ran} commands, {wrong} otherwise than the tutorial says")
    sys.exit(1 if wrong or not ran else 0)


main()
