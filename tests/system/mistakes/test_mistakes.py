"""Makes every mistake of a group and compares what Opal answers with the table.

    OPAL_PROGRAM=build/release/bin/opal python3 test_mistakes.py [GROUP or NAME...]
"""

import os
import sys
import tempfile

from mistake import Bench, complaints, run
from not_yet import NOT_YET
from table import GROUPS


def result_of(mistake, program):
    """What is wrong with Opal's answer, as lines of text; empty if nothing is."""
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(program, folder)
        answer = run(mistake, bench)
        wrong = complaints(mistake, answer, bench)
    if mistake.name in NOT_YET:
        return [] if wrong else ["is found by now: take it out of not_yet.py"]
    return wrong + ["it said:", *answer.text.splitlines()[:20]] if wrong else []


def main():
    program, chosen = os.environ["OPAL_PROGRAM"], sys.argv[1:]
    mistakes = [m for group, (_, all_of_it) in GROUPS.items() for m in all_of_it
                if not chosen or group in chosen or m.name in chosen]
    known = {m.name for _, all_of_it in GROUPS.values() for m in all_of_it}
    failed = [f"not_yet.py names '{name}', which is no mistake of the table" for name in NOT_YET.keys() - known]
    for mistake in mistakes:
        wrong = result_of(mistake, program)
        print("FAILED" if wrong else "not yet" if mistake.name in NOT_YET else "ok", "-", mistake.name, flush=True)
        if wrong:
            print("    " + "\n    ".join(wrong))
            failed.append(mistake.name)
    print(f"{len(mistakes)} mistakes, {len(failed)} with another answer than the table's" +
          (": " + ", ".join(failed) if failed else ""))
    return 1 if failed or not mistakes else 0


if __name__ == "__main__":
    sys.exit(main())
