"""filter.py page.md, from the top directory: a page for GitHub as one for Doxygen.

Headings get GitHub's names as labels, behind the name of their page. Links to
pages and headings lead there, links to other files become the names of these,
and a link to nothing becomes a reference that Doxygen complains of.
"""
import os
import re
import sys
from pathlib import Path

BLOCK = r"^ *(?P<fence>```|~~~)(?:.*\n)+?(?: *(?P=fence).*$|\Z)|(?:\A|\n\n)(?: {4}.*\n|\n)+"
HEADING = r"^(?P<hashes>#{1,6}) +(?P<title>.*?)(?: +#+)? *$"
DEFINITION = r"^ {0,3}(?P<name>\[[^]\n]+\]:) +(?P<meant>\S+)"
CODE = r"(?<!`)(?P<tick>`+)(?!`)(?P<code>(?:.|\n(?! *\n))+?)(?<!`)(?P=tick)(?!`)"
LINK = (r"(?P<image>!?)\[(?P<text>(?:[^][`]|`[^`]*`|\[[^][]*\])*)\]"
        r"\((?P<to>[^()\s]+)(?:\s+\"[^\"]*\")?\)")
STRONG = r"(?<![\w*])(?P<stars>\*\*?)(?=[^\s*])(?P<strong>(?:`[^`]*`|[^*`\n]|\n(?! *\n))+?)(?P=stars)(?![\w*])"
PART = re.compile(rf"{BLOCK}|{HEADING}|{DEFINITION}|\\.|{CODE}|{LINK}|{STRONG}|\bVoussoir\b(?!::)", re.M)
DECLARED = re.compile(r"^(?:class|struct|enum class) (\w+)\b(?!;)|^(?:\w.*[ &*])?(\w+)(?:\(| = .*;)", re.M)


def headings(path):
    """(title, GitHub's name, Doxygen's label) of each heading of a page."""
    found = []
    for m in PART.finditer(Path(path).read_text("utf-8")):
        if m["hashes"]:
            title = re.sub(f"{CODE}|{LINK}", lambda c: c["code"] or c["text"], m["title"])
            name = slug = re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
            while slug in [h[1] for h in found]:
                slug = f"{name}-{int(slug[len(name) + 1:] or 0) + 1}"
            label = f"{Path(path).stem}_{slug}" if found else Path(path).stem
            found.append((title, slug, re.sub(r"[^\w-]", lambda c: f"_{ord(c[0]):x}_", label, flags=re.A)))
    return found


def follow(link):
    """Where a link leads: an address in the manual or elsewhere, or a file."""
    path, _, anchor = link.partition("#")
    path = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
    if os.path.isfile(path) and re.fullmatch(r"README\.md|doc/.*\.md", path):
        html = ("index" if path == "README.md" else Path(path).stem) + ".html"
        labels = [label for _, slug, label in headings(path) if slug == anchor]
        return f"{html}#{labels[0]}" if labels else None if anchor else html, None
    if re.match(r"[a-z]+:|//", link):
        return link, None
    return None, path if os.path.exists(path) and not path.startswith("..") else None


def convert(m):
    """What comes in the place of a part of the page."""
    if m["hashes"]:
        return "{0} {1} {{#{3}}}".format(m["hashes"], *next(titles))
    if m["code"]:
        if re.fullmatch(r"\w+(::\w+)*(\(\))?", m["code"]) and re.match(r"\w+", m["code"])[0] in names:
            return f'<code>@ref Voussoir::{m["code"]} "{m["code"]}"</code>'
        # Doxygen takes `code with ' for quoted text, and knows no \| in code.
        words = m["code"]
        if re.search(r"^ *\|.*\Z", m.string[:m.start()], re.M):
            words = re.sub(r"( *)((?:\\\|)+)( *)", r"``\1<code>\2</code>\3``", words)
        return f"``{words}``".replace("````", "") if "'" in words or words != m["code"] else m[0]
    if m["strong"]:  # which Doxygen does not see before some letters
        tag = "strong" if len(m["stars"]) == 2 else "em"
        return f"<{tag}>{PART.sub(convert, m['strong'])}</{tag}>"
    link = m["to"] or m["meant"]
    if not link:
        return "%" + m[0] if m[0] == "Voussoir" else m[0]
    address, file = follow(link)
    if not address and (m["meant"] or not file):
        return "@ref nothing_at_" + re.sub(r"\W", "_", link)
    if m["meant"] or m["image"]:
        return f"{m['name']} {address}" if m["meant"] else f"![{m['text']}]({file or address})"
    text = PART.sub(convert, m["text"])
    if address:
        return f'<a href="{address}">{text}</a>'
    return f"`{file}`" if text.strip("`/") in (file, os.path.basename(file)) else f"{text} (`{file}`)"


page = os.path.relpath(sys.argv[1])
titles = iter(headings(page))
# In pages for developers code that names a part of Voussoir becomes a link.
headers = Path("include").rglob("*.h") if page in ("doc/developers.md", "doc/walk.md") else ()
names = {a or b for h in headers for a, b in DECLARED.findall(h.read_text("utf-8"))}
# The title comes first; what may be before it is a comment.
print(PART.sub(convert, re.sub(r"\A(?:<!--.*?-->|\s)+(?=# )", lambda m: "\n" * m[0].count("\n"),
                               Path(page).read_text("utf-8"), flags=re.S)), end="")
