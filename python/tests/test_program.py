"""A whole program: what reaches its standard output."""

import json
import subprocess
import sys
import unittest

from conversation import ball, line_of

PROGRAM = """
from touchstone_oracle import Contact, Oracle, serve
import os, subprocess, sys
print("an engine is loaded")
os.write(1, b"so says its C library\\n")
subprocess.run(["echo", "and a process of it"])

class Loud(Oracle):
    pairs = [("sphere", "sphere")]
    def contact(self, A, B):
        print("asked")
        if B.shape.radius == 7.0:
            sys.exit(3)
        return Contact(touching=True)

serve(Loud())
"""


def run(sent):
    return subprocess.run(
        [sys.executable, "-c", PROGRAM], input=sent, capture_output=True, timeout=60
    )


def question(number, radius=1.0):
    query = {"A": ball(0.0), "B": ball(1.0, radius)}
    return line_of({"id": number, "method": "contact", "queries": [query]})


class Program(unittest.TestCase):
    def test_writes_nothing_but_answers_to_standard_output(self):
        ended = run(question(4) + question(5) + line_of({"method": "bye"}))
        lines = [json.loads(line) for line in ended.stdout.splitlines()]
        answers = [{"touching": True}]
        self.assertEqual(lines, [{"id": 4, "answers": answers}, {"id": 5, "answers": answers}])
        for text in (b"is loaded", b"C library", b"process of it", b"asked"):
            self.assertIn(text, ended.stderr)
        self.assertEqual(ended.returncode, 0)

    def test_ends_if_its_engine_ends_it(self):
        ended = run(question(4) + question(5, radius=7.0) + question(6))
        self.assertEqual(len(ended.stdout.splitlines()), 1)
        self.assertEqual(ended.returncode, 3)


if __name__ == "__main__":
    unittest.main()
