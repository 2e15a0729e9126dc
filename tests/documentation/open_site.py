#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opens every page of the documentation site in a browser that reaches no network.

usage: open_site.py [DIRECTORY]

DIRECTORY is build/site by default, where "./squeal docs" writes it. A page that writes
an error to the console, asks for a file that is not there, or shows an equation that
MathJax could not set fails. Exit code 1 when one does.
"""

import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

from first_screens import CHROMIUM, ROOT, complaints_of


def complaints(page):
    """What the browser says against a page."""
    said = subprocess.run(CHROMIUM + ["--dump-dom", "file://" + page],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          check=False, timeout=180)
    found = complaints_of(said.stderr)
    if "<title" not in said.stdout:
        found.append("is empty")
    if re.search(r"<g[^>]*data-mml-node=\"merror\"", said.stdout):
        found.append("has an equation that cannot be set")
    return found


def main():
    site = os.path.abspath(sys.argv[1] if len(sys.argv) > 1
                           else os.path.join(ROOT, "build", "site"))
    pages = sorted(os.path.join(folder, name)
                   for folder, _, names in os.walk(site)
                   for name in names
                   if name.endswith(".html") and "/api/" not in folder + "/")
    failures = 0
    with ThreadPoolExecutor(2) as pool:
        for page, found in zip(pages, pool.map(complaints, pages)):
            for complaint in found:
                failures += 1
                print("FAILED", os.path.relpath(page, site) + ":", complaint)
    print(f"{len(pages)} pages, {failures} failures")
    return 1 if failures or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
