"""Tables: lists of rows, dictionaries of the same keys, as .csv files and as
Markdown."""
import csv
import math


def write(path, rows):
    """Write rows to a .csv file, numbers with six digits."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({key: f"{value:.6g}" if isinstance(value, float)
                             else value for key, value in row.items()})


def value_of(text):
    try:
        return float(text)
    except ValueError:
        return text


def read(path):
    """The rows of a .csv file, with numbers where there are numbers; none if
    there is no such file."""
    if not path.exists():
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return [{key: value_of(text) for key, text in row.items()}
                for row in csv.DictReader(file)]


def where(rows, **labels):
    """The rows with the given values."""
    return [row for row in rows
            if all(row[key] == value for key, value in labels.items())]


def distinct(rows, key):
    """The values of a column in the order in which they appear."""
    return list(dict.fromkeys(row[key] for row in rows))


def number(value):
    """A value as text of two or three digits; a dash if there is none."""
    if value == "":
        return "-"
    if isinstance(value, str):
        return value
    if not math.isfinite(value):
        return str(value)
    if value == int(value) and abs(value) < 1e6:
        return f"{int(value):,}"
    if 0.01 <= abs(value) < 1000:
        return f"{value:.{3 if abs(value) >= 1 else 2}g}"
    if 1000 <= abs(value) < 1e6:
        return f"{value:,.0f}"
    return f"{value:.1e}"


def power(value):
    """A round number, such as a tolerance, as in 1e-4; others as they are."""
    if f"{value:.0e}"[0] != "1" or float(f"{value:.0e}") != value:
        return f"{value:g}"
    return (f"{value:g}" if 1 <= value < 1e4 else
            f"{value:.0e}".replace("e-0", "e-").replace("e+0", "e"))


def ratio(row):
    """The time of a row and its spread."""
    return f"{number(row['time_ratio'])} ± {number(row['time_spread'])}"


def markdown(header, lines, left=1):
    """A table of texts; the first columns are aligned left."""
    rows = [header, [":--"] * left + ["--:"] * (len(header) - left), *lines]
    return "\n".join("| " + " | ".join(row) + " |" for row in rows) + "\n"


def listed(rows, columns, left=1):
    """A table of rows as they are; `columns` maps a heading to a key or to a
    function of the row."""
    return markdown(list(columns), [
        [get(row) if callable(get) else number(row[get])
         for get in columns.values()] for row in rows], left)


def pivot(rows, keys, across, entry, last=None):
    """A table with a line for each combination of `keys`, a dictionary from
    headings to keys, and a column for each value of `across`. `last` is the
    heading of a last column and a function of the rows of a line."""
    values = distinct(rows, across)
    lines = {}
    for row in rows:
        labels = tuple(row[key] for key in keys.values())
        lines.setdefault(labels, []).append(row)
    header = [*keys, *map(power, values), *([last[0]] if last else [])]
    return markdown(header, [
        [*map(str, labels),
         *(entry(where(line, **{across: value})[0]) for value in values),
         *([last[1](line)] if last else [])]
        for labels, line in lines.items()], len(keys))
