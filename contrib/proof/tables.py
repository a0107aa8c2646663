"""Tables and parameters as they are in files, of which nothing is missing."""
import csv
import math

from proof.arithmetic import minus, size_of

LENGTH = 1e-9  # the largest error of places, lengths and directions, over the lengths


class Unreadable(Exception):
    """Files that are not what a run writes."""


class Row(dict):
    """A line of a table. Its numbers are finite, but for those that are asked for by `wide`."""

    def __getitem__(self, name):
        value = float(super().__getitem__(name))
        if not math.isfinite(value):
            raise Unreadable(f"{name} is {value}")
        return value

    def get(self, name, needed=False, default=0.):
        """A number that only some results have."""
        return self[name] if needed or name in self else default

    def wide(self, name, needed=False, default=math.inf):
        """One that may be infinite, or None where it is empty."""
        if not needed and name not in self:
            return default
        text = super().__getitem__(name)
        if text and math.isnan(float(text)):
            raise Unreadable(f"{name} is {text}")
        return float(text) if text else None

    def vector(self, names, needed=True):
        """Two or three columns."""
        found = tuple(self.get(name, needed) for name in names)
        return found + (0.,) * (3 - len(found))

    def text(self, name):
        return super().__getitem__(name)

    def cells(self):
        """The two blocks of a joint."""
        return int(self.text("cell_minus")), int(self.text("cell_plus"))

    def has(self, name):
        """True of a column that is there and not empty."""
        return name in self and self.text(name) != ""


def xyz(name):
    return [f"{name}_{x}" for x in "xyz"]


def table(file, number):
    """The lines of a table, of which there must be `number`, if that is known."""
    text = file.read_text(encoding="utf-8")
    if not text.endswith("\n"):
        raise Unreadable(f"{file.name} ends within a line")
    header, *lines = csv.reader(text.splitlines())
    if number is not None and len(lines) != number:
        raise Unreadable(f"{file.name} has {len(lines)} lines and not {number}")
    for k, line in enumerate(lines):
        if len(line) != len(header):
            raise Unreadable(f"{file.name} has {len(line)} values in line {k + 2}")
    return [Row(zip(header, line)) for line in lines]


def entries_of(file):
    """The parameters of a run by their paths, as in Supports/Displacement."""
    found, path = {}, []
    for line in file.read_text(encoding="utf-8").splitlines():
        words = line.split("#", 1)[0].split(None, 1)
        if words[:1] == ["subsection"]:
            path.append(words[1].strip())
        elif words[:1] == ["end"]:
            path.pop()
        elif words[:1] == ["set"]:
            name, value = words[1].split("=", 1)
            found["/".join(path + [name.strip()])] = value.strip()
    return found


def numbers(text, separator=";"):
    """A list of numbers, padded to a vector; None if it is anything else, as a formula."""
    try:
        found = tuple(map(float, text.split(separator)))
    except ValueError:
        return None
    return found + (0.,) * (3 - len(found))


def check_same(one, other, needed, but=()):
    """Two tables say the same in the columns that both have, and that both must have."""
    if len(one) != len(other):
        raise Unreadable("two tables of the same have other numbers of lines")
    for a, b in zip(one, other):
        for name in set(needed) | (a.keys() & b.keys() - set(but)):
            if a.text(name) != b.text(name):
                raise Unreadable(f"{name} differs between two tables")


def check_near(what, a, b, size):
    if not size_of(minus(a, b)) <= LENGTH * size:
        raise Unreadable(f"{what} is {a}, and should be {b}")


def check_number(row, k):
    """Lines are in the order of the numbers of blocks."""
    if row.text("id") != str(k):
        raise Unreadable(f"block {row.text('id')} is in the place of block {k}")
