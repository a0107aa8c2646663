#!/usr/bin/env python3
"""Every message that the program can print explains itself or is explained:

    messages.py [TOP DIRECTORY OF THE PROJECT]

Messages are the string literals in source/ of what is thrown, refused, noticed or
warned of. An error of input explains itself if it says what to do, or what is
expected; a refusal also if that stands in the sentence around it. All others must be
quoted in doc/troubleshooting.md, at least with their longest literal. And what that page
quotes in bold are messages of the program: every part of a quotation between "..." of
three words or more is in a string literal, or in JOINED below.
"""
import re
import sys
from pathlib import Path

CALLS = re.compile(
    r"throw (?P<InputError>InputError\()|throw (?P<SolverError>SolverError\()"
    r"|terminal\.(?P<warning>warning\()|notices\.(?P<notice>push_back\()"
    r"|\b(?P<refusal>(?:refuse\w*|differ)\()")
OUTCOME = re.compile(r"\boutcome = \"([^\"]*)\";")
# Parts of sentences that are put together elsewhere.
OTHERS = [
    "The load is not carried: along a mechanism of the blocks that closes no joint it does",
    "The dead loads alone, without 'Live loads', are not carried:",
    "The dead loads are not carried with any factor of 'Live loads', which do no work along a "
    "mechanism",
    "Whether they are carried beside some factor of 'Live loads' is not known.",
    "work that friction does not resist", "Not convex:",
    "is not determined by the forces on their edges, and the mean stress is written instead.",
    "face each other across a gap near", "within the matching tolerance",
    "The packing, supports and strengths must be those of the run that the forces are from; "
    "leave 'Forces from' empty to solve.", "A file or directory cannot be used:",
    "Clp, which solves the linear programmes of all states, has failed.",
    "There is not enough memory for this packing.", "Interrupted by", "no effect, since",
    "An unexpected error, which is a defect of the program, ended the run:",
    "nothing to balance", "stopped at a looser tolerance", "failed to restore feasibility",
    "failed to compute a step", "ended with the status",
    "without forces that balance the load: the certificate finds",
    "do not carry the load of this run: the certificate finds",
    "No load acts on the packing, so that all forces are zero.",
    "but may differ from those of the named selection."]
# An imperative at the beginning of a clause, the words for what is expected, or two
# entries that contradict each other.
INSTRUCTION = re.compile(
    r"(?:^|[.;:] |, (?:or|and|so) )(?:change|choose|copy|cut|delete|draw|give|keep|leave|"
    r"lower|make|merge|move|name|open|redraw|reduce|remove|rename|repeat|run|save|see|set|take|"
    r"try|write)\b|\bmust (?:be|have)\b|\b(?:are|was) expected\b|\bshould be\b|\bneeds (?:one|"
    r"a|at least)\b|\ba polygon has at least|\bthere may be\b|is not of the form|; the form is|"
    r"only .* may follow|; a cell is one loop|; a line holds one|; the nearest are|which reaches "
    r"from|have the numbers from|' is '[^']*', but '", re.IGNORECASE)
# Quoted, but joined when the program runs, or in deal.II's words.
JOINED = [
    "times the work that friction can dissipate, so that no forces within the strengths of the "
    "interfaces balance it; these would have to be at least that many times as large, and "
    "perhaps more", "has no effect, since", "have no effect, since",
    "The load is not carried: the packing collapses in a mechanism in which joints close by",
    "The dead loads are not carried, with any factor of the live loads: the packing collapses in "
    "a mechanism",
    "The dead loads are not carried, and no factor of the live loads is known that helps: the "
    "packing collapses in a mechanism",
    "without forces that balance the load: the certificate finds a residual of",
    "do not carry the load of this run: the certificate finds a residual of",
    "each within the matching tolerance",
    "has fewer than three vertices left of which no two are within the matching tolerance",
    "The Z coordinates of", "The curves of",
    "but outside of all sections; add the 'end' that is missing before, or move it there"]
# Read in deal.II's messages, and not printed.
READ = ("The entry value", "for the entry named", "does not match the given pattern", "The line <",
        "No entry with name", "> was declared in", "There is no such", "> could not be parsed")
HANDED_ON = re.compile(r"\b(fault|reason|where|advice|same_scene|here)\b")
TOKEN = re.compile(r"//[^\n]*|/\*.*?\*/|'(?:[^'\\\n]|\\.)'|\"((?:[^\"\\]|\\.)*)\"", re.DOTALL)


def normal(text):
    return " ".join(text.split())


def without_comments(code):
    """Nor characters, such as '('; strings are left as they are."""
    return TOKEN.sub(lambda token: token.group() if token.group()[0] == '"'
                     else "\n" * token.group().count("\n"), code)


def arguments(code, begin):
    """From behind an opening parenthesis to the closing one."""
    depth, i = 1, begin
    while i < len(code) and depth:
        literal = TOKEN.match(code, i)
        depth += 0 if literal else {"(": 1, ")": -1}.get(code[i], 0)
        i = literal.end() if literal else i + 1
    return code[begin:i - 1]


def message(call):
    """The literals, joined where nothing is between them, and what follows the last."""
    found, end = [], 0
    for literal in TOKEN.finditer(call):
        if not found or call[end:literal.start()].strip():
            found.append("")
        found[-1] += literal.group(1).replace('\\"', '"')
        end = literal.end()
    return [normal(text) for text in found], call[end:]


def is_quoted(literals, manual):
    longest = max(literals, key=len)
    if len(longest.split()) >= 3:
        return longest in manual
    return ("**" + "...".join(literals)).replace(" ", "") in manual.replace(" ", "")


def check_file(code, manual):
    """How many messages there are and are quoted, and those that are unexplained."""
    calls = [(match, arguments(code, match.end())) for match in CALLS.finditer(code)]
    around = any(re.search(r"\b(fault|reason)\b", call) and
                 INSTRUCTION.search(" ... ".join(message(call)[0]))
                 for match, call in calls if match.lastgroup == "InputError")
    n_messages, n_quoted, unexplained = 0, 0, []
    for match, call in calls:
        kind = match.lastgroup
        literals, tail = message(call)
        if not any(literals) or HANDED_ON.search(tail):
            continue  # what it ends with is looked at by itself
        text = " ... ".join(literals)
        quoted = is_quoted(literals, manual)
        explains = INSTRUCTION.search(text) or kind == "refusal" and around
        n_messages += 1
        n_quoted += quoted
        if not quoted and not (explains and kind in ("InputError", "refusal")):
            unexplained.append((code.count("\n", 0, match.start()) + 1, text))
    return n_messages, n_quoted, unexplained


def stale(manual, literals):
    """What the manual quotes in bold and no literal has, and exceptions it does not quote."""
    quoted = "...".join(re.findall(r"\*\*(.+?)\*\*", manual))
    parts = [part.strip(" '.,;") for part in re.split(r"\.\.\.|(?<=[^.]\.) ", quoted)]
    return [part for part in parts if len(part.split()) >= 3 and part not in literals
            and part not in JOINED] + [part for part in JOINED if part not in parts]


def main(top):
    manual = normal(Path(top, "doc", "troubleshooting.md").read_text("utf-8"))
    counts, failures, literals = [0, 0], [], []
    for file in sorted([*Path(top, "source").rglob("*.cc"), *Path(top, "include").rglob("*.h")]):
        code = without_comments(file.read_text("utf-8"))
        n_messages, n_quoted, unexplained = check_file(code, manual)
        counts = [counts[0] + n_messages, counts[1] + n_quoted]
        failures += [f"{file.name}:{line}: {text}" for line, text in unexplained]
        failures += [f"{file.name}: the outcome '{outcome}'"
                     for outcome in OUTCOME.findall(code) if outcome not in manual]
        literals += [text for text in message(code)[0] if not text.startswith(READ)]
    literals = "\n".join(literals)
    failures += [text for text in OTHERS if text not in manual or text not in literals]
    failures = ["to be quoted in doc/troubleshooting.md: " + text for text in failures]
    failures += ["quoted there, but not in source/: " + text for text in stale(manual, literals)]
    print(*failures, f"{counts[0]} messages, {counts[1]} of them quoted", sep="\n")
    return 0 if not failures and counts[0] > 100 else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]))
