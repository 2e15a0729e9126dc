# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the site needs beside the pages in doc/.

The pages are written for the repository: they link to parameter files, sources and pages
outside doc/. Files that a page links to become part of the site, below repository/; the
links follow them. MathJax is copied from the package that pip has installed.
"""

import os
import posixpath
import re
from importlib import metadata
from urllib.parse import urlsplit

from mkdocs.structure.files import File

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
HERE = os.path.relpath(os.path.dirname(os.path.abspath(__file__)), ROOT)
LINK = re.compile(r"(\]\()([^)\s]+)(\))")
FENCE = re.compile(r"^(```.*?^```)", re.MULTILINE | re.DOTALL)


def place_in_repository(src_uri):
    """The path in the repository of a page of the site."""
    if src_uri.startswith("repository/"):
        return src_uri[len("repository/"):]
    return "doc/" + src_uri


def place_in_site(path):
    """The path in the site of a file of the repository, seen from the pages' root."""
    if path.startswith("doc/"):
        return path[len("doc/"):]
    if path.endswith(".md") or path.endswith(".txt"):
        return "repository/" + path
    return "repository/" + path + ".txt"


def target_of(link, path):
    """(path in the repository, rest) of a relative link on the page at path, or None."""
    parts = urlsplit(link)
    if parts.scheme or parts.netloc or not parts.path:
        return None
    target = posixpath.normpath(posixpath.join(posixpath.dirname(path), parts.path))
    return target, ("#" + parts.fragment if parts.fragment else "")


def links_of(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as page:
        text = FENCE.sub("", page.read())
    for match in LINK.finditer(text):
        found = target_of(match.group(2), path)
        if found:
            yield found[0]


def on_files(files, config):
    def add(uri, source):
        if files.get_file_from_path(uri) is None:
            files.append(File.generated(config, uri, abs_src_path=source))

    waiting = [place_in_repository(f.src_uri) for f in files.documentation_pages()]
    seen = set(waiting)
    while waiting:
        for target in links_of(waiting.pop()):
            if target in seen or not os.path.isfile(os.path.join(ROOT, target)):
                continue
            seen.add(target)
            if not target.startswith("doc/"):
                add(place_in_site(target), os.path.join(ROOT, target))
            if target.endswith(".md"):
                waiting.append(target)
    for name in ("mathjax.js", "site.css"):
        add("assets/squeal/" + name, os.path.join(ROOT, HERE, name))
    for packaged in metadata.files("django-static-mathjax"):
        if str(packaged).endswith(("mathjax/es5/tex-svg.js", "static/mathjax/LICENSE")):
            add("assets/mathjax/" + packaged.name, str(packaged.locate()))
    return files


def on_page_markdown(markdown, page, config, files):
    path = place_in_repository(page.file.src_uri)

    def follow(match):
        found = target_of(match.group(2), path)
        if not found or not os.path.isfile(os.path.join(ROOT, found[0])):
            return match.group(0)
        here = posixpath.dirname(page.file.src_uri) or "."
        target = posixpath.relpath(place_in_site(found[0]), here)
        return match.group(1) + target + found[1] + match.group(3)

    if page.file.src_uri == "development.md":
        # Made by Doxygen after this site, so that no file is there to link to.
        markdown = markdown.replace(
            "`api/annotated.html`", '<a href="api/annotated.html">classes and functions</a>')
    parts = FENCE.split(markdown)
    return "".join(p if p.startswith("```") else LINK.sub(follow, p) for p in parts)
