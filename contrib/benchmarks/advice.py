"""What the tables say: choices and sentences, all computed from their rows."""
import math

from tables import distinct, number, power, where

EXACT = 1e-6  # error up to which a uniform stress counts as returned
CHEAP = 1.2  # time, over that of the loosest tolerance, that counts as cheap
ACCURACIES = (1e-2, 1e-4, 1e-6)  # that the cheapest setting is looked for
MEASURES = {"distance": "distance to the canonical state",
            "residual": "residual"}


def in_words(names, last="and"):
    """Some names as an enumeration."""
    names = list(names)
    if len(names) < 2:
        return "".join(names)
    return f"{', '.join(names[:-1])} {last} {names[-1]}"


def solved(rows):
    return where(rows, outcome="solved")


def root_mean_square(values):
    """The root mean square."""
    values = list(values)
    return math.sqrt(sum(value**2 for value in values) / len(values))


def exact_ways(rows):
    """The rows of those ways that return a uniform stress at the largest number
    of cells, the fastest first."""
    cells = max(row["cells"] for row in rows)
    return sorted((row for row in solved(where(rows, cells=cells))
                   if row["patch_error"] <= EXACT),
                  key=lambda row: row["time_ratio"])


def formulation_advice(rows):
    """Which formulation is the fastest of those that are exact."""
    ways = exact_ways(rows)
    if not ways:
        return f"no formulation returns a uniform stress to {power(EXACT)}"
    text = (f"{ways[0]['way']} is the fastest of the formulations that return "
            f"a uniform stress to {power(EXACT)} "
            f"({number(ways[0]['seconds'])} s for "
            f"{number(ways[0]['cells'])} cells)")
    if len(ways) > 1:
        times = ways[1]["time_ratio"] / ways[0]["time_ratio"]
        text += (f", {number(times)} times faster than the next, "
                 f"{ways[1]['way']}")
    return text


def last_answers(rows):
    """For each way the smallest distance to collapse up to which it answers
    in all structures that were measured."""
    distances = sorted(distinct(rows, "distance_to_collapse"), reverse=True)
    last = dict.fromkeys(distinct(rows, "way"), math.inf)
    for way in last:
        for distance in distances:
            here = where(rows, way=way, distance_to_collapse=distance)
            if len(solved(here)) < len(here):
                break
            last[way] = distance
    return last


def rigidity_advice(rows):
    """Which formulation answers closest to collapse."""
    last = last_answers(rows)
    closest = min(last.values())
    if math.isinf(closest):
        return "close to collapse none answers in all structures measured"
    ways = [way for way in last if last[way] == closest]
    verb = "answer" if len(ways) > 1 else "answers"
    text = (f"of the structures measured here {in_words(ways)} {verb} all "
            f"closest to collapse, up to {power(closest)} from it")
    if len(ways) == 1:
        return text
    fastest = min(ways, key=lambda way: root_mean_square(
        row["time_ratio"] for row in
        where(rows, way=way, distance_to_collapse=closest)))
    return f"{text}, {fastest} in the least time there"


def cheap_tolerance(rows, way):
    """The tightest tolerance of a way that costs at most CHEAP times the
    loosest, in every scene; None if the loosest has no answer."""
    own = solved(where(rows, way=way, equilibrate="false"))
    cheap = []
    for scene in distinct(rows, "scene"):
        times = {row["tolerance"]: row["time_ratio"]
                 for row in where(own, scene=scene)}
        if not times:
            return None
        loosest = times[max(times)]
        cheap.append(min(tolerance for tolerance, time in times.items()
                         if time <= CHEAP * loosest))
    return max(cheap)


def tolerance_advice(rows):
    """Which tolerance is the tightest that costs little, for each way."""
    ways = {}
    for way in distinct(rows, "way"):
        ways.setdefault(cheap_tolerance(rows, way), []).append(way)
    loosest = power(max(row["tolerance"] for row in rows))
    parts = [f"{power(tolerance)} for {in_words(ways[tolerance])}"
             for tolerance in sorted(ways.keys() - {None})]
    return (f"the tightest tolerance that costs at most {CHEAP} times as much "
            f"as {loosest}, far from and close to collapse, is "
            f"{in_words(parts)}")


def cheapest(rows, measure, accuracy):
    """Of the rows with a measure up to `accuracy` the fastest, or that with the
    loosest tolerance of those that it does not beat; None if there is none."""
    good = [row for row in solved(rows)
            if row[measure] != "" and row[measure] <= accuracy]
    fastest = min(good, key=lambda row: row["time_ratio"], default=None)
    return max((row for row in good if not beats(fastest, row)),
               key=lambda row: row["tolerance"], default=None)


def beats(one, other):
    """Whether the row `one` takes less time than `other`, by 5 per cent and
    beyond the spread of both."""
    return bool(one) and (
        not other or
        one["time_ratio"] < 0.95 * other["time_ratio"] and
        one["time_ratio"] + one["time_spread"] <
        other["time_ratio"] - other["time_spread"])


def looser(one, other):
    """Whether a row has a looser tolerance than another, if there is one."""
    return not other or one["tolerance"] > other["tolerance"]


def equilibrate_choices(rows):
    """For each scene, way, measure and accuracy: the cheapest setting without
    and with Equilibrate."""
    return [{"scene": scene, "way": way, "measure": measure,
             "accuracy": accuracy,
             "without": cheapest(where(rows, scene=scene, way=way,
                                       equilibrate="false"), measure, accuracy),
             "with": cheapest(where(rows, scene=scene, way=way,
                                    equilibrate="true"), measure, accuracy)}
            for measure in MEASURES for scene in distinct(rows, "scene")
            for way in distinct(rows, "way") for accuracy in ACCURACIES]


def equilibrate_advice(rows):
    """When Equilibrate beats a tighter tolerance."""
    wins = [choice for choice in equilibrate_choices(rows)
            if beats(choice["with"], choice["without"]) and
            looser(choice["with"], choice["without"])]
    sentences = []
    for measure, name in MEASURES.items():
        parts = []
        for way in distinct(where(wins, measure=measure), "way"):
            own = where(wins, measure=measure, way=way)
            asked = max(choice["accuracy"] for choice in own)
            used = sorted({choice["with"]["tolerance"] for choice in own})
            parts.append(f"{way} (from {power(asked)} on, with the tolerance "
                         f"{in_words(map(power, used), 'or')}; "
                         f"{in_words(distinct(own, 'scene'))})")
        sentences.append(
            f"to reach a given {name}, `Equilibrate` beats a tighter tolerance "
            + (f"with {in_words(parts)}" if parts else "with no formulation"))
    return "; ".join(sentences)


def stress_error(rows, setting, load, measure="distance"):
    """The mean of a measure over the polygons under a load, without the
    triangle, which has uniform stresses only if it has no torque; empty if
    there is none."""
    found = [row[measure] for row in
             where(rows, structure="polygon", load=load, setting=setting)
             if row["sides"] > 3 and row[measure] != ""]
    return root_mean_square(found) if found else ""


def stress_time(rows, setting):
    """The row of the time of a setting."""
    return where(rows, structure="timed random cells", setting=setting)[0]


def halving(rows, load):
    """The setting that halves the error of `standard` under a load for the
    least time; None if none does."""
    bound = (stress_error(rows, "standard", load) or 0) / 2
    good = [setting for setting in distinct(rows, "setting")
            if stress_time(rows, setting)["time_ratio"] != "" and
            (stress_error(rows, setting, load) or math.inf) <= bound]
    return min(good, default=None, key=lambda setting:
               stress_time(rows, setting)["time_ratio"])


def stress_advice(rows):
    """Which reconstruction gains most for its time."""
    parts = []
    for load, name in (("uneven, no torque", "without a residual torque"),
                       ("uneven, torque", "with one")):
        setting = halving(rows, load)
        before = number(stress_error(rows, "standard", load))
        parts.append(
            f"in blocks {name} nothing tried halves the error of `standard`, "
            f"{before}" if setting is None else
            f"in blocks {name} the cheapest setting that halves the error of "
            f"`standard` is {setting} "
            f"({number(stress_error(rows, setting, load))} instead of "
            f"{before}, in "
            f"{number(stress_time(rows, setting)['time_ratio'])} times the time "
            f"of `standard`)")
    return "; ".join(parts)


def sentence(parts):
    """Parts as one sentence, the missing ones left out."""
    text = "; ".join(part for part in parts if part)
    return text[:1].upper() + text[1:] + "." if text else "Not measured."


def lines(tables):
    """The advice, from the rows of all tables by name."""
    def said(name, advice):
        return advice(tables[name]) if tables[name] else ""
    return [
        "**Formulation.** " + sentence([
            said("formulations", formulation_advice),
            said("rigidity", rigidity_advice)]),
        "**Tolerance.** " + sentence([
            said("tolerance", tolerance_advice),
            said("tolerance", equilibrate_advice)]),
        "**Stress.** " + sentence([said("reconstruction", stress_advice)])]
