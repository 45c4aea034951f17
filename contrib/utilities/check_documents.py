#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks that the documents speak of things that exist: paths in back quotes, tests (Suite.Name) and citations.

Usage: check_documents.py [project's root]. Prints file:line: message for every breach; exit status 1 if there is one.
"""

import re
import sys
from pathlib import Path

PATH = re.compile(r"`((?:contrib|doc|include|prm|source|tests)/[\w./-]+)`")
TEST = re.compile(r"`([A-Z]\w+\.[A-Z]\w+)`")
TEST_DEFINITION = re.compile(r"\bTEST(?:_F|_P)?\(\s*(\w+)\s*,\s*(\w+)\s*\)")
CITATION = re.compile(r"\b([A-Z][A-Za-z]+(?:19|20)\d\d)\b")
CITATION_DEFINITION = re.compile(r"^@\w+\{([^,\s]+),", re.MULTILINE)


def breaches(root):
    """All messages, as file:line: text."""
    sources = (path.read_text(encoding="utf-8") for path in (root / "tests").rglob("*.cc"))
    tests = {f"{suite}.{name}" for text in sources for suite, name in TEST_DEFINITION.findall(text)}
    works = set(CITATION_DEFINITION.findall((root / "doc" / "references.bib").read_text(encoding="utf-8")))
    for document in [root / "README.md", *sorted((root / "doc").rglob("*.md"))]:
        for number, line in enumerate(document.read_text(encoding="utf-8").splitlines(), start=1):
            where = f"{document.relative_to(root)}:{number}:"
            yield from (f"{where} there is no '{path}'" for path in PATH.findall(line) if not (root / path).exists())
            yield from (f"{where} there is no test '{test}'" for test in TEST.findall(line) if test not in tests)
            yield from (f"{where} '{work}' is not in doc/references.bib" for work in CITATION.findall(line) if work not in works)


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]
    found = list(breaches(root))
    for line in found:
        print(line)
    print(f"{len(found)} references that lead nowhere")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
