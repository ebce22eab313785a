# SPDX-License-Identifier: MIT
"""What a page has to keep to whatever browser shows it: `faults(path)` lists what it does not."""
import html.parser
import pathlib
import re
import urllib.parse

VOID = {"area", "base", "br", "col", "hr", "img", "input", "link", "meta", "source", "wbr"}
LOADING = {"src", "srcset", "poster", "data", "action"}  # attributes that make a browser ask


class Page(html.parser.HTMLParser):
    """Walks through a page and notes its faults."""

    def __init__(self):
        super().__init__()
        self.open_tags, self.ids, self.anchors, self.files, self.labels = [], set(), [], [], []
        self.faults = []
        self.doctype = None

    def fault(self, what):
        self.faults.append(f"line {self.getpos()[0]}: {what}")

    def handle_decl(self, decl):
        self.doctype = decl

    def handle_starttag(self, tag, attributes):
        names = [name for name, _ in attributes]
        if len(names) != len(set(names)):
            self.fault(f"<{tag}> has an attribute twice")
        given = dict(attributes)
        self.note_links(tag, given)
        if "id" in given:
            if not given["id"] or given["id"] in self.ids:
                self.fault(f"id '{given['id']}' is empty or used twice")
            self.ids.add(given["id"])
        if tag == "img" and not given.get("alt"):
            self.fault("a picture without a text for those who do not see it")
        if tag == "img" and not (given.get("width") and given.get("height")):
            self.fault("a picture without its size")
        if tag == "th" and "scope" not in given:
            self.fault("<th> without scope")
        if tag not in VOID:
            self.open_tags.append(tag)

    def note_links(self, tag, given):
        for name in LOADING & given.keys():
            if not given[name].startswith("data:"):
                self.fault(f"<{tag} {name}> is not inside the page: {given[name][:60]}")
        if tag == "label":
            self.labels.append(given.get("for"))
        link = given.get("href")
        if link is None or link.startswith("data:"):
            return
        if tag != "a":
            self.fault(f"<{tag}> loads {link}")
        elif link.startswith("#"):
            self.anchors.append(link[1:])
        else:
            self.files.append(link)

    def handle_endtag(self, tag):
        if tag in VOID or not self.open_tags or self.open_tags[-1] != tag:
            self.fault(f"</{tag}> where {self.open_tags[-1:] or 'nothing'} is open")
        if tag in self.open_tags:
            while self.open_tags.pop() != tag:
                pass


def link_faults(page, folder):
    """Anchors, labels and files that lead nowhere."""
    for anchor in page.anchors:
        if urllib.parse.unquote(anchor) not in page.ids:
            yield f"#{anchor} leads nowhere"
    for label in page.labels:
        if label not in page.ids:
            yield f"a label for '{label}', which is not there"
    for file in page.files:
        parts = urllib.parse.urlsplit(file)
        if parts.scheme or parts.netloc or file.startswith("/"):
            continue  # may be anywhere
        if not (folder / urllib.parse.unquote(parts.path)).is_file():
            yield f"{file} is not beside the page"


def faults(path):
    """What is wrong with the page, one line each; none where all is well."""
    path = pathlib.Path(path)
    text = path.read_text(encoding="utf-8")
    page = Page()
    page.feed(text)
    page.close()
    found = list(page.faults)
    if (page.doctype or "").lower() != "doctype html":
        found.append("no <!DOCTYPE html>")
    found += [f"<{tag}> stays open" for tag in page.open_tags]
    found += link_faults(page, path.parent)
    style = "".join(re.findall(r"<style>(.*?)</style>", text, re.S))
    if re.search(r"@import|url\((?!['\"]?data:)", style):
        found.append("the style sheet loads something")
    return found
