#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the commands of the pages and compares what the pages quote with what is printed.

    tests/documentation/run_pages.py [--keep DIRECTORY] [--gallery SECONDS]
                                     [--compare-only] [PAGE...]

Without pages: the first run, the tutorials, the how-to pages, and the gallery's scenes that take
no longer than --gallery (30 s). Every page runs in a scratch directory that holds a copy of
prm/ and doc/ and a link to the launcher, so that its commands are those that a reader types.

A page's commands are its code blocks whose first line begins with one of COMMANDS, and the blocks
marked "python"; the others show files. The block "prints" behind a Python block is
compared with its output. A line that asks the network is passed over and named, and so is a
scene of the gallery that reads the results of one that has not run. Figures of scenes of the
gallery that are too long here are compared by --compare-only: it runs nothing and takes the results
in --keep, which first_screens.py has made.

figures.csv has the other figures, one a row:

    page       where the figure stands
    quoted     the text as it stands there; gone from the page, it is an offence
    file       the result file, or "log" for what the commands of the page print
    where      rows of it, as "column=value" joined by ";"
    nearest    of these the row whose column is nearest, as "column=number"
    column     that is compared; "count" is the number of rows
    value      the number as quoted; for a log the text that has to be printed
    tolerance  half a unit of its last digit if it is empty

Exit code 1 when a command fails, a figure differs or a quotation has gone.
"""
import argparse
import csv
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", ".."))
FIGURES = os.path.join(os.path.dirname(os.path.realpath(__file__)), "figures.csv")
COMMANDS = ("./squeal run", "./squeal compare", "./squeal validate", "python3 ", "gnuplot ")
NETWORK = ("pip install", "apt-get", "gmsh-venv", "http.server", "python3 -m venv")
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```", re.MULTILINE | re.DOTALL)
GALLERY = "doc/gallery.md"


def default_pages():
    pages = ["doc/first_run.md"]
    for folder in ("doc/howto", "doc/tutorial"):
        pages += sorted(os.path.join(folder, name)
                        for name in os.listdir(os.path.join(ROOT, folder))
                        if name.endswith(".md"))
    return pages + [GALLERY]


def text_of(page):
    with open(os.path.join(ROOT, page), encoding="utf-8") as file:
        return file.read()


def blocks_of(page):
    """[(kind, text, what it has to print or None)]; kinds are "shell", "python" and
    "gnuplot", a script of which the page says "as a file `NAME`" in front."""
    text = text_of(page)
    found = list(BLOCK.finditer(text))
    blocks = []
    for number, match in enumerate(found):
        language, body = match.group(1), match.group(2)
        if language == "python":
            printed = None
            if number + 1 < len(found):
                between = text[match.end():found[number + 1].start()].strip()
                if between == "prints":
                    printed = found[number + 1].group(2)
            blocks.append(("python", body, printed))
        elif body.lstrip().startswith(COMMANDS):
            blocks.append(("shell", body, None))
        else:
            named = re.findall(r"as a\s+file `([^`]+)`", text[:match.start()].split("```")[-1])
            if named:
                blocks.append((named[-1], body, None))
    return blocks


def quick_scenes(seconds):
    """Files of the gallery that take no longer, each with a block of its own."""
    blocks = []
    for line in text_of(GALLERY).splitlines():
        match = re.match(r"\| \[[^\]]*\]\(\.\./(prm/[^)]*)\).*\| ([^|]*) \| ([^|]*) \|$", line)
        taken = match and re.match(r"(?:&lt; )?(\d+) s$", match.group(2))
        if taken and int(taken.group(1)) <= seconds:
            blocks.append(("shell", "./squeal run %s\n" % match.group(1), None))
    return blocks


class Page:
    def __init__(self, page, directory, gallery_seconds, all_have_run=False):
        self.page, self.directory, self.all_have_run = page, directory, all_have_run
        self.log, self.offences = "", []
        self.blocks = quick_scenes(gallery_seconds) if page == GALLERY else blocks_of(page)

    def offence(self, text):
        self.offences.append("%s: %s" % (self.page, text))
        print("  FAILED  " + text, flush=True)

    def execute(self, command, shown):
        begin = time.monotonic()
        done = subprocess.run(command, cwd=self.directory, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                              encoding="utf-8", errors="replace")
        print("  %6.1f s  %s" % (time.monotonic() - begin, shown), flush=True)
        self.log += done.stdout
        if done.returncode:
            tail = "\n".join(done.stdout.splitlines()[-12:])
            self.offence("exit code %d of: %s\n%s" % (done.returncode, shown, tail))
        return done.stdout

    def shell(self, body):
        lines = body.replace("\\\n", " ").splitlines()
        for line in lines:
            line = line.split(" #")[0].strip()
            if not line or line.startswith("#"):
                continue
            if any(word in line for word in NETWORK):
                print("  passed over (network): " + line)
                continue
            self.execute(["bash", "-c", line], re.sub(r"\s+", " ", line))

    def missing(self, body):
        """A result of another scene that the scene of the gallery reads and that no run has
        written, or None."""
        scene = os.path.join(self.directory, body.split()[-1])
        with open(scene, encoding="utf-8") as file:
            read = re.findall(r"^\s*set [^=\n]*=\s*(\S*output/\S*\.(?:h5|csv|png))", file.read(),
                              re.MULTILINE)
        for name in read:
            path = os.path.normpath(os.path.join(os.path.dirname(scene), name))
            if not os.path.exists(path):
                return os.path.relpath(path, self.directory)
        return None

    def run(self):
        print(self.page, flush=True)
        for kind, body, printed in self.blocks:
            if self.page == GALLERY and self.missing(body):
                print("  passed over, as %s is not there: %s"
                      % (self.missing(body), body.strip()))
            elif kind == "shell":
                self.shell(body)
            elif kind == "python":
                shown = body.strip().splitlines()[0]
                output = self.execute(["/usr/bin/python3", "-c", body], "Python: " + shown)
                if printed is not None and output != printed:
                    self.offence("prints\n%sinstead of\n%s" % (output, printed))
            else:
                with open(os.path.join(self.directory, kind), "w", encoding="utf-8") as file:
                    file.write(body)

    def row_of(self, figure):
        """The rows that a figure asks for."""
        with open(os.path.join(self.directory, figure["file"]), encoding="utf-8",
                  newline="") as file:
            rows = list(csv.DictReader(file))
        for condition in filter(None, figure["where"].split(";")):
            column, value = condition.split("=", 1)
            rows = [row for row in rows if same(row[column], value)]
        if figure["nearest"] and rows:
            column, value = figure["nearest"].split("=")
            rows = [min(rows, key=lambda row: abs(float(row[column] or "inf") - float(value)))]
        return rows

    def compare(self, figure):
        if " ".join(figure["quoted"].split()) not in " ".join(text_of(self.page).split()):
            self.offence("does not say \"%s\" any more" % figure["quoted"])
        if figure["file"] == "log":
            if figure["value"] not in self.log:
                self.offence("\"%s\" is not printed" % figure["value"])
            return
        folder = os.path.dirname(os.path.join(self.directory, figure["file"]))
        if self.page == GALLERY and not self.all_have_run and not os.path.isdir(folder):
            print("      left  %s (its scene has not run)" % figure["quoted"])
            return
        try:
            rows = self.row_of(figure)
        except (OSError, KeyError, ValueError) as error:
            self.offence("%s: %s %s" % (figure["file"], type(error).__name__, error))
            return
        if figure["column"] == "count":
            reached = float(len(rows))
        elif len(rows) == 1 and rows[0].get(figure["column"]):
            reached = float(rows[0][figure["column"]])
        else:
            self.offence("%s: %d rows, or no column %s, for \"%s\"" % (
                figure["file"], len(rows), figure["column"], figure["quoted"]))
            return
        allowed = float(figure["tolerance"]) if figure["tolerance"] else half_a_unit(
            figure["value"])
        # Written so that a NaN is no agreement.
        if not abs(reached - float(figure["value"])) <= allowed * (1 + 1e-9):
            self.offence("%s of %s is %.8g, quoted \"%s\"" % (
                figure["column"], figure["file"], reached, figure["quoted"]))
        else:
            print("      ok    %s (%.8g)" % (figure["quoted"], reached))


def same(cell, value):
    try:
        return abs(float(cell) - float(value)) <= 1e-9 * max(1.0, abs(float(value)))
    except ValueError:
        return cell == value


def half_a_unit(text):
    mantissa, _, exponent = text.lower().partition("e")
    digits = len(mantissa.partition(".")[2])
    return 0.5 * 10.0 ** (int(exponent or 0) - digits)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--keep", help="directory that is used and left")
    parser.add_argument("--gallery", type=int, default=30, help="longest scene of the gallery, s")
    parser.add_argument("--compare-only", action="store_true", help="runs nothing")
    parser.add_argument("pages", nargs="*")
    options = parser.parse_args()
    with open(FIGURES, encoding="utf-8", newline="") as file:
        figures = list(csv.DictReader(file))
    pages = options.pages or default_pages()
    unknown = {f["page"] for f in figures} - set(default_pages())
    offences = ["figures.csv: %s is no page that runs" % page for page in sorted(unknown)]

    scratch = options.keep or tempfile.mkdtemp(prefix="squeal_pages_")
    os.makedirs(scratch, exist_ok=True)
    for folder in ("prm", "doc"):
        shutil.copytree(os.path.join(ROOT, folder), os.path.join(scratch, folder),
                        dirs_exist_ok=True)
    if not os.path.lexists(os.path.join(scratch, "squeal")):
        os.symlink(os.path.join(ROOT, "squeal"), os.path.join(scratch, "squeal"))
    commands = compared = 0
    try:
        for name in pages:
            page = Page(name, scratch, options.gallery, options.compare_only)
            if not options.compare_only:
                page.run()
            commands += len(page.blocks)
            for figure in figures:
                if figure["page"] == name:
                    compared += 1
                    page.compare(figure)
            offences += page.offences
    finally:
        if not options.keep:
            shutil.rmtree(scratch, ignore_errors=True)
    for offence in offences:
        print(offence)
    print("pages: %d blocks of commands on %d pages, %d figures, %d offences"
          % (commands, len(pages), compared, len(offences)))
    return 1 if offences or not commands else 0


if __name__ == "__main__":
    sys.exit(main())
