"""Check the relative links of Markdown files: the file must exist, and so must the heading.

usage: python3 CheckLinks.py FILE.md...

Prints one line a dead link ("file:line: link: reason") and exits 1 where there is any. Links to
the web are not followed.
"""

import pathlib
import re
import sys

# [text](target) and ![text](target), with an optional title; [label]: target
INLINE = re.compile(r'\]\(\s*<?([^)\s>]+)>?(?:\s+"[^"]*")?\s*\)')
LABEL = re.compile(r"^\s{0,3}\[[^\]]+\]:\s*<?(\S+?)>?\s*$")
FENCE = re.compile(r"^\s*(```|~~~)")


def prose(text):
    """The lines that are not inside a code block, code spans blanked, with their numbers."""
    fenced = False
    for number, line in enumerate(text.splitlines(), 1):
        if FENCE.match(line):
            fenced = not fenced
        elif not fenced:
            yield number, re.sub(r"`[^`]*`", "`", line)


def anchors(path):
    """The anchors that a Markdown file's headings get on the usual hosts."""
    found = set()
    fenced = False
    for line in path.read_text(encoding="utf-8").splitlines():
        if FENCE.match(line):
            fenced = not fenced
        heading = None if fenced else re.match(r"^#{1,6}\s+(.*?)\s*#*$", line)
        if heading:
            words = re.sub(r"[^\w\- ]", "", heading.group(1).lower()).replace(" ", "-")
            anchor, count = words, 0
            while anchor in found:
                count += 1
                anchor = f"{words}-{count}"
            found.add(anchor)
        for name in re.findall(r'<a (?:id|name)="([^"]+)"', line):
            found.add(name)
    return found


def fault(path, link):
    """Why a link of the file at `path` is dead, or None."""
    if re.match(r"^[a-zA-Z][a-zA-Z0-9+.-]*:", link):
        return None
    target, _, anchor = link.partition("#")
    file = (path.parent / target) if target else path
    if target.startswith("/"):
        return "must be relative"
    if not file.exists():
        return "no such file"
    if anchor and file.suffix == ".md" and anchor not in anchors(file):
        return "no such heading"
    return None


def main(names):
    dead = 0
    for path in map(pathlib.Path, names):
        for number, line in prose(path.read_text(encoding="utf-8")):
            for link in INLINE.findall(line) + LABEL.findall(line):
                reason = fault(path, link)
                if reason:
                    print(f"{path}:{number}: {link}: {reason}")
                    dead += 1
    return 1 if dead else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
