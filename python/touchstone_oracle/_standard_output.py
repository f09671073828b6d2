"""Standard output, kept for answers alone.

Many engines print to standard output when they are loaded or run, and one stray line there
would break the conversation with Touchstone. Importing this module keeps a copy of
descriptor 1 for the answers and makes descriptor 1 another name of standard error. The
prints of Python and those of C libraries then both end up there.
"""

from __future__ import annotations

import io
import os
import sys
from typing import BinaryIO, Optional


def _claim() -> Optional[BinaryIO]:
    try:
        answers = os.dup(1)
    except OSError:
        return None  # The program was started without a standard output.
    try:
        # Text that still waits in sys.stdout is not flushed before: it is no answer either.
        os.dup2(2, 1)
    except OSError:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, 1)
        os.close(nowhere)
    if isinstance(sys.stdout, io.TextIOWrapper):
        # Prints then appear in the order of other lines on standard error.
        sys.stdout.reconfigure(line_buffering=True)
    return os.fdopen(answers, "wb")


_answers = _claim()


def answer_stream() -> BinaryIO:
    """Returns the stream that was standard output when the package was imported."""
    if _answers is None:
        raise RuntimeError("there is no standard output to write answers to")
    return _answers
