#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prepares what doxygen makes the site of, and checks the site.

  .ci/make_pages.py FOLDER          writes FOLDER/input, FOLDER/pictures and FOLDER/files
  .ci/make_pages.py --check FOLDER  prints the links of FOLDER/html that lead nowhere, and fails if there are some

A README becomes a page; that of a stage of the core the text of the stage's group, which also has the filters and all
that the folder's headers declare. (Not by @ingroup in the filters' headers: Python's help would show it.) Links between READMEs become references. Other files
that they name become pages with their text.
"""

import html.parser
import os
import pathlib
import re
import shutil
import sys
import urllib.parse

from check_includes import CORE, FILTERS, TOP, stages

# Groups without a README in Filters/Core. A folder in Filters/ belongs to the group of its name.
GROUPS = {
    "Whole": "Whole: all stages, one after another",
    "Conversion": None,
    "Exchange": "Exchange: axes from and for other programs",
    "Collections": "Collections: many objects",
    "Python": "Python: an update on a thread of its own",
    "Pipeline": "Pipeline: what all filters do alike when they run",
}
FILTERS_OF_GROUPS = {
    "Whole": ["vtkSimplifyShape"],
    "Images": ["vtkImageBoundary"],
    "Samples": ["vtkBoundarySamples", "vtkCleanScan"],
    "Balls": ["vtkPolarBalls"],
    "Axis": ["vtkMedialAxis"],
    "Parts": ["vtkMedialPartDecomposition"],
    "Pruning": ["vtkMedialPrune"],
    "Crust": ["vtkPowerCrust"],
    "Measuring": ["vtkLocalThickness", "vtkMorphometry", "vtkPlatesAndRods", "vtkMedialCenterlines"],
    "Exchange": ["vtkMedialMeshReader", "vtkMedialMeshWriter"],
    "Collections": ["vtkShareOutObjects", "vtkCollectParts"],
    "Python": ["vtkBackgroundUpdate"],
}
GROUP_OF_FOLDER = {"Imaging": "Images"}

CODE = re.compile(r"(^```.*?^```$|`[^`]*`)", re.S | re.M)
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)")
NAMESPACE = re.compile(r"^(namespace medial\n)\{(.*?^)\}$", re.S | re.M)
HEADING = re.compile(r"^(#+) (.*)$", re.M)


def pages():
    """All READMEs and other texts, the first page first."""
    found = sorted(TOP.glob("*.md"), key=lambda path: path.name != "README.md")
    for folder in ("Filters", "Examples", "ParaView", "Testing"):
        found += sorted((TOP / folder).rglob("*.md"), key=lambda path: (len(path.parts), path))
    return found


def groups():
    """The groups' names in the order of the site: all together, the stages as the data flows, the rest."""
    first, *rest = GROUPS
    return [first, *stages(), *rest]


def group_of_header(header):
    if header.parent != FILTERS:
        return GROUP_OF_FOLDER.get(header.parent.name, header.parent.name)
    for group, filters in FILTERS_OF_GROUPS.items():
        if header.stem in filters:
            return group
    sys.exit("%s: is in no group of .ci/make_pages.py" % header.name)


def group_of_page(page):
    """The group whose text a README is, or None."""
    folder = page.parent
    if page.name == "README.md" and (folder.parent == CORE or folder == FILTERS / "Conversion"):
        return folder.name
    return None


def label_of_page(page):
    name = page.relative_to(TOP).with_suffix("").as_posix()
    return group_of_page(page) or "page_" + re.sub(r"\W", "_", name.replace("/README", ""))


def label_of_heading(page, heading):
    """As GitHub makes anchors, with the page's name before."""
    slug = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "_").replace("-", "_")
    return label_of_page(page) + "_" + slug


class Site:
    def __init__(self, folder):
        self.folder = folder
        self.files = []  # which pages name and which are no pages
        for name in ("input", "pictures", "files", "html"):
            shutil.rmtree(folder / name, ignore_errors=True)

    def write(self, name, text):
        path = self.folder / "input" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def target(self, page, link):
        """What doxygen calls the place that a link of a page leads to."""
        path, _, anchor = link.partition("#")
        file = (page.parent / path).resolve() if path else page
        if not file.is_file():
            sys.exit("%s: there is no %s" % (page.relative_to(TOP), link))
        if file.suffix == ".h":
            return "@ref " + file.stem
        if file.suffix != ".md":
            if file not in self.files:
                self.files.append(file)
            return "@ref " + label_of_page(file)
        return "@ref " + (label_of_heading(file, anchor.replace("-", " ")) if anchor else label_of_page(file))

    def link(self, page, found):
        picture, text, link = found.groups()
        if link.startswith("http"):
            return found.group()
        if picture:
            shutil.copy(page.parent / link, self.picture(link))
            return "![%s](%s)" % (text, os.path.basename(link))
        return "[%s](%s)" % (text, self.target(page, link))

    def picture(self, link):
        (self.folder / "pictures").mkdir(exist_ok=True)
        path = self.folder / "pictures" / os.path.basename(link)
        if path.exists():
            sys.exit("Two pictures are called " + path.name)
        return path

    def text(self, page):
        """A page in doxygen's words."""
        pieces = CODE.split(page.read_text())
        for i in range(0, len(pieces), 2):
            pieces[i] = LINK.sub(lambda found: self.link(page, found), pieces[i])
        fences = re.split(r"(^```.*?^```$)", "".join(pieces), flags=re.S | re.M)
        for i in range(0, len(fences), 2):
            fences[i] = HEADING.sub(lambda found: self.heading(page, *found.groups()), fences[i])
        return "".join(fences)

    def heading(self, page, level, words):
        label = label_of_page(page) if level == "#" else label_of_heading(page, words)
        return "%s %s {#%s}" % (level, words, label)

    def add_page(self, page):
        if not group_of_page(page):
            self.write(page.relative_to(TOP), self.text(page))

    def add_group(self, name, title):
        folder = FILTERS / "Conversion" if name == "Conversion" else CORE / name
        text = ""
        if (folder / "README.md").is_file():
            heading, text = self.text(folder / "README.md").split("\n", 1)
            title = re.match(r"# (.*) \{#", heading).group(1)
        text = HEADING.sub(lambda found: found.group()[1:], text)  # a group's text begins with sections
        filters = ", ".join(FILTERS_OF_GROUPS.get(name, []))
        lines = ["@defgroup %s %s" % (name, title), "Filters: %s.\n" % filters if filters else "", *text.splitlines()]
        self.write("groups/%02d.dox" % groups().index(name), "".join("/// %s\n" % line for line in "\n".join(lines).split("\n")))

    def add_header(self, header):
        """What a folder's header declares goes into the folder's group, on the same lines as before."""
        begin, end = "/** @addtogroup %s */ /** @{ */" % group_of_header(header), "/** @} */"
        text = header.read_text()
        if header.parent == FILTERS:
            text = "%s\n%s%s\n" % (begin, text.split("\n", 1)[1], end)
        else:
            text = NAMESPACE.sub(r"\1{ %s\2%s }" % (begin, end), text)
        self.write(header.relative_to(TOP), text)

    def add_file(self, file):
        name = file.relative_to(TOP).as_posix()
        copy = self.folder / "files" / name.replace("/", "_")
        copy.parent.mkdir(exist_ok=True)
        shutil.copy(file, copy)
        self.write("files/%s.dox" % copy.name,
                   "/** @page %s %s\n@verbinclude %s\n*/\n" % (label_of_page(file), name, copy.name))


def make(folder):
    site = Site(folder)
    for page in pages():
        site.add_page(page)
    for name in groups():
        site.add_group(name, GROUPS.get(name))
    for header in sorted(FILTERS.rglob("*.h")):
        site.add_header(header)
    for file in site.files:
        site.add_file(file)


class Links(html.parser.HTMLParser):
    """Where a page of the site leads to, and the anchors that it has."""

    def __init__(self, path):
        super().__init__()
        self.targets, self.anchors = [], set()
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("id", "name") and value:
                self.anchors.add(value)
            elif name in ("href", "src", "data") and value and tag != "link":
                self.targets.append(value)


def dead_links(folder):
    links = {path.name: Links(path) for path in sorted((folder / "html").glob("*.html"))}
    for page, found in links.items():
        for target in found.targets:
            if re.match(r"[a-z]+:", target):
                continue
            name, _, anchor = urllib.parse.unquote(target).partition("#")
            if anchor == "nested-classes":  # where all of these are private, doxygen names a list that it leaves out
                continue
            name = name or page
            if not (folder / "html" / name).is_file() or anchor and anchor not in links[name].anchors:
                yield "%s: %s" % (page, target)


if __name__ == "__main__":
    if sys.argv[1] == "--check":
        dead = list(dead_links(pathlib.Path(sys.argv[2])))
        print("\n".join(dead))
        sys.exit(bool(dead))
    make(pathlib.Path(sys.argv[1]).resolve())
