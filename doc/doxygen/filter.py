"""Turn a Markdown page that is written for GitHub into one for Doxygen.

Usage, from the top directory: filter.py page.md; the result is on the standard
output. Headings get GitHub's names as labels, behind the name of their page.
Links to pages and headings lead there, links to other files become the names
of these, and a link to nothing a reference that Doxygen complains of.
"""
import glob
import os
import re
import sys

BLOCK = r"^ *(?P<fence>```|~~~)(?:.*\n)+?(?: *(?P=fence).*$|\Z)|(?:\A|\n\n)(?: {4}.*\n|\n)+"
HEADING = r"^(?P<hashes>#{1,6}) +(?P<title>.*?)(?: +#+)? *$"
CODE = r"(?P<tick>`+)(?P<code>(?:[^`\n]|\n(?! *\n))+)(?P=tick)"
LINK = (r"(?P<image>!?)\[(?P<text>(?:[^][`]|`[^`]*`|\[[^][]*\])*)\]"
        r"\((?P<to>[^()\s]+)(?:\s+\"[^\"]*\")?\)")
PART = re.compile(rf"{BLOCK}|{HEADING}|\\.|{CODE}|{LINK}|\bVoussoir\b(?!::)", re.M)
# In these pages code in backticks that names a part of Voussoir is a link.
FOR_DEVELOPERS = ("doc/developers.md", "doc/walk.md")


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def headings(path):
    """(title, GitHub's name, Doxygen's label) of each heading."""
    found, page = [], os.path.basename(path)[:-3]
    for m in PART.finditer(read(path)):
        if m["hashes"]:
            title = re.sub(f"{CODE}|{LINK}", lambda c: c["code"] or c["text"], m["title"])
            name = slug = re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
            while slug in [h[1] for h in found]:
                slug = f"{name}-{int(slug[len(name) + 1:] or 0) + 1}"
            label = f"{page}_{slug}" if found else page
            found.append((title, slug, re.sub(r"[^\w-]", lambda c: f"_{ord(c[0]):x}_", label, flags=re.A)))
    return found


def follow(link, path):
    """Where a link in the page leads: an address in the manual, and a file."""
    if re.match(r"[a-z]+:|//", link):
        return link, None
    file, _, anchor = link.partition("#")
    file = os.path.normpath(os.path.join(os.path.dirname(path), file)) if file else path
    if file == "README.md" or re.fullmatch(r"doc/.*\.md", file) and os.path.isfile(file):
        html = "index.html" if file == "README.md" else os.path.basename(file)[:-3] + ".html"
        labels = [f"{html}#{label}" for _, slug, label in headings(file) if slug == anchor]
        return html if not anchor else labels[0] if labels else None, None
    return None, file if os.path.exists(file) and not file.startswith("..") else None


def convert(text, path, names, titles):
    def replace(m):
        in_table = text[text.rfind("\n", 0, m.start()) + 1:m.end()].lstrip().startswith("|")
        if m["hashes"]:
            title, _, label = next(titles)
            return f"{m['hashes']} {title} {{#{label}}}"
        if m["code"]:
            if re.fullmatch(r"\w+(::\w+)*(\(\))?", m["code"]) and re.match(r"\w+", m["code"])[0] in names:
                return f'<code>@ref Voussoir::{m["code"]} "{m["code"]}"</code>'
            # Doxygen knows no | in the code of a table.
            return re.sub(r" *((?:\\\|)+) *", r"` <code>\1</code> `", m[0]) if in_table else m[0]
        if not m["to"]:
            return "%" + m[0] if m[0] == "Voussoir" else m[0]
        address, file = follow(m["to"], path)
        if not address and not file:
            return "@ref nothing_at_" + re.sub(r"\W", "_", m["to"])
        if m["image"] or (address == m["to"] and not address.endswith(".html")):
            return m[0]
        words = convert(m["text"], path, (), iter(()))
        if address:
            return f'<a href="{address}">{words}</a>'
        return f"`{file}`" if words.strip("`/") in (file, os.path.basename(file)) else f"{words} (`{file}`)"
    return PART.sub(replace, text)


def names_of_voussoir():
    """What the headers declare at the beginning of a line."""
    declared = r"^(?:class|struct|enum class) (\w+)\b(?!;)|^(?:\w.*[ &*])?(\w+)(?:\(| = .*;)"
    headers = glob.glob("include/voussoir/**/*.h", recursive=True)
    return {a or b for h in headers for a, b in re.findall(declared, read(h), re.M)}


page = os.path.relpath(sys.argv[1])
names = names_of_voussoir() if page in FOR_DEVELOPERS else ()
# The title comes first; what may be before it is a comment.
text = re.sub(r"\A(?:<!--.*?-->|\s)+(?=# )", lambda m: "\n" * m[0].count("\n"), read(page), flags=re.S)
print(convert(text, page, names, iter(headings(page))), end="")
