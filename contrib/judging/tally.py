"""What has been found so far: disagreements, their files, and the table."""
import collections
import shutil

CLASSES = ("not carried", "bounded", "unbounded", "doubtful")
# Of these the largest counts, and of the others the sum.
LARGEST = ("difference", "miss")
COLUMNS = ("scenes", *CLASSES, "propped", "states", "undecided", "overruled", "faults",
           *LARGEST)
# Of a line on the screen; the file has all of it.
LONGEST = 400


class Tally:
    """Counts by kind of scene, law and rotations."""

    def __init__(self, keep, finds_limits=True):
        self.keep = keep
        self.finds_limits = finds_limits
        self.rows = collections.defaultdict(collections.Counter)
        self.now = collections.Counter()
        self.n_faults = 0

    def report(self, kind, run, words):
        """List a disagreement, and keep what repeats it."""
        self.keep.mkdir(parents=True, exist_ok=True)
        words = " ".join(words.split())
        kept = self.keep / run.prm.name
        kept.write_text(f"# {kind}: {words}\n{run.prm.read_text()}")
        for drawing in run.prm.parent.glob("*.wkt"):
            shutil.copy(drawing, self.keep)
        print(f"{kind}: {kept.name}: {words[:LONGEST]}", flush=True)
        if kind == "fault":
            self.n_faults += 1
        self.now["faults" if kind == "fault" else kind] += 1

    def add(self, judgement):
        """Count a scene, and what has been reported since the last one."""
        scene = judgement.scene
        row = self.rows[scene.kind, scene.law,
                        "true" if scene.rotations else "false"]
        row.update(scenes=1, states=judgement.n_states)
        row[judgement.kind] += 1
        # Of those that are carried the ones that are not without live loads.
        row["propped"] += getattr(judgement, "is_propped", False)
        for kind in ("undecided", "overruled", "faults"):
            row[kind] += self.now[kind]
        for name in LARGEST:
            row[name] = max(row[name], getattr(judgement, name))
        self.now.clear()

    def total(self):
        """The counts of all scenes."""
        total = collections.Counter()
        for row in self.rows.values():
            for name in {*row}:
                total[name] = max(total[name], row[name]) if name in LARGEST \
                    else total[name] + row[name]
        return total

    def has_failed(self):
        """Whether there are faults, or too few limits where these are looked for."""
        total = self.total()
        return self.n_faults > 0 or self.finds_limits and \
            3 * total["bounded"] < total["scenes"] - 6

    def print(self, seconds):
        """The table, with a line for all."""
        total = self.total()
        lines = [("kind", "law", "rotations", *COLUMNS),
                 *((*key, *cells_of(row)) for key, row in
                   sorted(self.rows.items())),
                 ("all", "", "", *cells_of(total))]
        widths = [max(map(len, column)) for column in zip(*lines)]
        for line in lines:
            print("  ".join(cell.ljust(width) if i < 3 else cell.rjust(width)
                            for i, (cell, width) in
                            enumerate(zip(line, widths))))
        print(f"{total['scenes']} scenes, {total['states']} states, "
              f"{self.n_faults} faults, {seconds:.0f} s")
        if self.keep.exists():
            print(f"The .prm files are in {self.keep}")


def cells_of(row):
    """The texts of one line."""
    return [f"{row[name]:.1e}" if name in LARGEST else str(row[name])
            for name in COLUMNS]
