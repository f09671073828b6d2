"""Checks the transcripts against docs/oracle_protocol.schema.json: every message is valid but
the questions that are answered with an error.

    schema_test.py SCHEMA TRANSCRIPT...
"""

import json
import sys

import jsonschema


def messages_of(transcript):
    """Yields the lines of a transcript without their mark, and whether each is valid."""
    lines = [line.rstrip("\n") for line in open(transcript, encoding="utf-8")]
    lines = [line for line in lines if line.startswith(("> ", "< "))]
    for line, after in zip(lines, lines[1:] + [""]):
        is_refused = line.startswith("> ") and after.startswith('< {"id":') and '"error"' in after
        # An error about one question of a message leaves the message valid.
        yield line[2:], not (is_refused and "answers" not in after)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        schema = json.load(file)
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    counts = {True: 0, False: 0}
    for transcript in sys.argv[2:]:
        for text, is_valid in messages_of(transcript):
            try:
                is_accepted = validator.is_valid(json.loads(text))
            except ValueError:
                is_accepted = False
            if is_accepted != is_valid:
                sys.exit(f"{transcript}: accepted: {is_accepted}; expected {is_valid}: {text}")
            counts[is_valid] += 1
    print(f"{counts[True]} messages are valid, {counts[False]} are refused")
    if min(counts.values()) < 3:
        sys.exit("expected at least three of each")


main()
