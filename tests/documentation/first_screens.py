#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the scenes of the gallery, opens every report and draws its first screen.

Each report is opened in a headless Chromium that reaches no network; a page that
writes an error to the console, or asks for another file, fails. The first screens
become the contact sheets doc/pictures/first_screens_*.png, doc/first_screens.md
says the sentence of each, and the gallery gets the sheets, the times and the memory.
Exit code 1 when a run or a page fails.

usage: first_screens.py [--runs DIRECTORY] [--scenes PATTERN] [--longest SECONDS]
                        [--only-open] [--write]

--runs       where the runs are made and kept (a new one by default); a scene
             whose report is there is not run again
--scenes     only those whose name holds the regular expression
--longest    runs that take longer are given up and listed
--only-open  runs nothing: opens the reports that are there
--write      writes the sheets and the page; all scenes have to be there
"""

import argparse
import html
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.realpath(__file__)), "../.."))
WIDTH, HEIGHT, COLUMNS, ROWS = 1180, 720, 3, 4
ROW = re.compile(r"^\| \[([^\]]+)\]\(\.\./(prm/[^)]+\.prm)\) \| ([^|]*) \|")
CHROMIUM = ["chromium", "--headless", "--no-sandbox", "--use-gl=angle",
            "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
            "--hide-scrollbars", "--disable-background-networking",
            "--host-resolver-rules=MAP * ~NOTFOUND", "--enable-logging=stderr",
            "--virtual-time-budget=4000"]


def scenes_of_gallery():
    """Chapter, name, file and question of every row, in the order of the page."""
    chapter, result = "", []
    with open(os.path.join(ROOT, "doc/gallery.md"), encoding="utf-8") as page:
        for line in page:
            if line.startswith("## "):
                chapter = line[3:].strip()
            if match := ROW.match(line):
                result.append((chapter, *match.groups()))
    return result


def run(file, runs, longest):
    """Runs a file in the folder of runs, which holds a copy of prm/: files that read
    what others have written find it there. Returns what went wrong, or nothing."""
    log = os.path.join(runs, file.replace("/", "_") + ".log")
    with open(log, "w", encoding="utf-8") as out:
        try:
            code = subprocess.run([os.path.join(ROOT, "squeal"), "run",
                                   file],
                                  cwd=runs, stdout=out, stderr=out, timeout=longest,
                                  check=False).returncode
        except subprocess.TimeoutExpired:
            return f"not ready after {longest} s"
    return f"exit code {code}, see {log}" if code else None


def reports(file, runs):
    """The reports that a run of a file has named, by its log."""
    log = os.path.join(runs, file.replace("/", "_") + ".log")
    if not os.path.isfile(log):
        return []
    with open(log, encoding="utf-8") as lines:
        names = re.findall(r"read\s+(\S+report\.html)", lines.read())
    return [p for p in (os.path.join(runs, n) for n in names) if os.path.isfile(p)]


def complaints_of(log):
    """The lines of a browser's log that tell of an error of a page."""
    return [line for line in log.splitlines()
            if ":CONSOLE" in line and re.search(r"error|fail|uncaught", line, re.I)]


def screenshot(page, picture, height):
    """Draws the top of a page. Returns the complaints of the browser."""
    said = subprocess.run(
        CHROMIUM + [f"--window-size={WIDTH},{height}", f"--screenshot={picture}",
                    "file://" + os.path.abspath(page)],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False,
        timeout=180).stdout
    complaints = complaints_of(said)
    if not os.path.isfile(picture):
        complaints.append("no picture was drawn")
    return complaints


def asked_for(page):
    """Addresses of other files that the page would load by itself."""
    with open(page, encoding="utf-8") as text:
        content = re.sub(r"<script[^>]*>.*?</script>", "", text.read(), flags=re.S)
    loaded = re.findall(r"<(?:img|script|iframe|source)[^>]*\ssrc=\"([^\"]*)\"", content)
    loaded += re.findall(r"<link[^>]*\shref=\"([^\"]*)\"", content)
    return [address for address in loaded if not address.startswith("data:")]


def sentence_of(page):
    """What the first screen answers."""
    with open(page, encoding="utf-8") as text:
        match = re.search(r"<strong>(.*?)</strong>", text.read(), re.S)
    return html.unescape(re.sub(r"<[^>]+>", "", match.group(1))).strip() if match else ""


def work_of(file, runs):
    """CPU seconds and memory of the run of a file, as the gallery writes them; nothing
    if it has not run."""
    log = os.path.join(runs, file.replace("/", "_") + ".log")
    if not os.path.isfile(log):
        return {}
    with open(log, encoding="utf-8") as lines:
        names = re.findall(r"^results:\s+([^\s,]+)", lines.read(), re.M)
    record = os.path.join(runs, names[0], "run.json") if names else ""
    if not os.path.isfile(record):
        return {}
    with open(record, encoding="utf-8") as text:
        run_record = json.load(text)
    seconds, gigabytes = run_record["cpu_s"], run_record["peak_memory_mb"] / 1000
    if seconds < 1:
        time = "&lt; 1 s"
    else:
        time = f"{seconds:.0f} s" if seconds < 300 else f"{seconds / 60:.0f} min"
    return {"time": time, "memory": f"{gigabytes:.1f} GB"}


def sheet(cells, path):
    """A picture of first screens, (name, picture) each, a row of three."""
    rows = (len(cells) + COLUMNS - 1) // COLUMNS
    with tempfile.TemporaryDirectory() as folder:
        page = os.path.join(folder, "sheet.html")
        with open(page, "w", encoding="utf-8") as out:
            out.write("<style>body{margin:0;background:#dfe4ea;font:15px sans-serif}"
                      "div{display:grid;grid-template-columns:repeat(3,1fr);gap:14px;"
                      "padding:14px}figure{margin:0}img{width:100%;display:block}"
                      "figcaption{padding:3px}</style><div>")
            for name, picture in cells:
                out.write(f"<figure><figcaption>{html.escape(name)}</figcaption>"
                          f"<img src=\"file://{picture}\"></figure>")
            out.write("</div>")
        command = [a for a in CHROMIUM if not a.startswith("--virtual")]
        height = 14 + rows * (14 + 24 + (1650 - 56) // 3 * HEIGHT // WIDTH)
        subprocess.run(command + ["--allow-file-access-from-files",
                                  f"--window-size=1650,{height}",
                                  f"--screenshot={path}", "file://" + page],
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
    if shutil.which("convert"):
        subprocess.run(["convert", path, "-strip", "-colors", "96", "PNG8:" + path],
                       check=True)


def write_sheets(entries):
    """The sheets of every chapter. Returns their lines in a page, chapter by chapter."""
    pictures = os.path.join(ROOT, "doc/pictures")
    for old in os.listdir(pictures):
        if old.startswith("first_screens_"):
            os.remove(os.path.join(pictures, old))
    shown, number = {}, 0
    for entry in entries:
        shown.setdefault(entry["chapter"], [])
    for chapter, lines in shown.items():
        mine = [e for e in entries if e["chapter"] == chapter]
        for first in range(0, len(mine), COLUMNS * ROWS):
            number += 1
            name = f"first_screens_{number:02d}.png"
            sheet([(e["name"], e["picture"]) for e in mine[first:first + COLUMNS * ROWS]],
                  os.path.join(pictures, name))
            lines += [f"![First screens: {chapter}](pictures/{name})"]
    return shown


def write_page(entries, sheets):
    """The page that leads through the sheets, with the sentence of every report."""
    lines = ["# First screens", "",
             "The first screen of a report answers the question of its run in a "
             "sentence. These",
             "are those of all scenes of the [gallery](gallery.md), as",
             "`tests/documentation/first_screens.py` has drawn them.", ""]
    for chapter, pictures in sheets.items():
        lines += ["## " + chapter, ""]
        for picture in pictures:
            lines += [picture, ""]
        lines += ["| scene | what its report says first |", "| --- | --- |"]
        lines += [f"| [{e['name']}](../{e['file']}) | "
                  + e["sentence"].replace("|", "\\|") + " |"
                  for e in entries if e["chapter"] == chapter]
        lines += [""]
    with open(os.path.join(ROOT, "doc/first_screens.md"), "w", encoding="utf-8") as page:
        page.write("\n".join(lines[:-1]) + "\n")


def write_gallery(work, sheets):
    """Times, memory and sheets of the gallery; questions and answers stay."""
    path = os.path.join(ROOT, "doc/gallery.md")
    with open(path, encoding="utf-8") as page:
        lines = [line for line in page.read().splitlines()
                 if not line.startswith("![First screens")]
    result = []
    for line in lines:
        match = ROW.match(line)
        if match and work.get(match.group(2)):
            cells = line.split(" | ")
            entry = work[match.group(2)]
            cells[-2:] = [entry["time"], entry["memory"] + " |"]
            line = " | ".join(cells)
        if line == "" and result and result[-1] == "":
            continue
        result.append(line)
        if line.startswith("## ") and sheets.get(line[3:].strip()):
            result.append("")
            for picture in sheets[line[3:].strip()]:
                result += [picture, ""]
    with open(path, "w", encoding="utf-8") as page:
        page.write("\n".join(result) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs")
    parser.add_argument("--scenes", default="")
    parser.add_argument("--longest", type=float, default=3600)
    parser.add_argument("--only-open", action="store_true")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    runs = os.path.abspath(options.runs or tempfile.mkdtemp(prefix="squeal_screens_"))
    os.makedirs(os.path.join(runs, "screens"), exist_ok=True)
    shutil.copytree(os.path.join(ROOT, "prm"), os.path.join(runs, "prm"), dirs_exist_ok=True)
    entries, failures = [], []
    for chapter, name, file, _ in scenes_of_gallery():
        if not re.search(options.scenes, name):
            continue
        if not options.only_open and not reports(file, runs):
            print("run  ", name, flush=True)
            if problem := run(file, runs, options.longest):
                failures.append(f"{name}: {problem}")
        for page in reports(file, runs)[:1]:
            picture = os.path.join(runs, "screens", file.replace("/", "_") + ".png")
            problems = screenshot(page, picture, HEIGHT)
            problems += ["asks for " + address for address in asked_for(page)]
            sentence = sentence_of(page)
            if not sentence:
                problems.append("has no sentence that answers")
            failures += [f"{name}: {problem}" for problem in problems]
            print("open ", name + ":", sentence, flush=True)
            entries.append({"chapter": chapter, "name": name, "file": file,
                            "picture": picture, "sentence": sentence})
    if options.write:
        sheets = write_sheets(entries)
        write_page(entries, sheets)
        write_gallery({file: work_of(file, runs) for _, _, file, _ in scenes_of_gallery()},
                      sheets)
    for failure in failures:
        print("FAILED", failure)
    print(f"{len(entries)} reports, {len(failures)} failures; runs in {runs}")
    return 1 if failures or not entries else 0


if __name__ == "__main__":
    sys.exit(main())
