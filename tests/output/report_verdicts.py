"""What a report says first, for check_reports.py: one sentence for each analysis, by the
numbers of summary.json.
"""


def factor(words, summary):
    """True if the factor is there with four digits."""
    carried = summary["load_factor"]
    value = carried.get("forces_at", carried["carried"])
    return f"{value:.4g}" in words


def check_verdicts(said, expect):
    """`said` runs a scene with settings, and returns a sentence of its page and the summary."""
    live = "times the live loads are carried and no more, proven within"
    words, of = said("block_on_incline")
    expect(words, factor(words, of) and live in words)
    words, of = said("block_on_incline", "Load factor/Direction=least")
    expect(words, factor(words, of) and "and no less" in words)
    words, of = said("block_on_incline", "Friction/Law=Coulomb")
    expect(words, factor(words, of) and words.startswith("Without dilatancy"))
    words, of = said("dry_arch")
    expect(words, factor(words, of) and "all strengths divided by" in words and
           "as they are" not in words)
    words, of = said("dry_arch", "Friction/Coefficient=0.1")
    expect(words, factor(words, of) and words.endswith(": not with the strengths as they are."))
    words, of = said("dry_arch", "Load factor/Factor=all loads")
    expect(words, factor(words, of) and "so is any factor beyond" in words)
    words, of = said("rocking_wall", "Capacity/Largest displacement=0.1", "Units/Length=m")
    expect(words, f"{of['capacity']['points'][0]['carried']:.4g} times" in words and
           "gone by 0.1 m: there" in words)
    words, of = said("rocking_wall", "Units/Length=m")
    expect(words, f"by {of['capacity']['ultimate_displacement']:.4g} m." in words)
    words, of = said("spreading_arch", "Units/Length=cm", selector="answer")
    expect(words, f"by up to {of['settlement']['largest_displacement']:.4g} cm" in words and
           f"{of['settlement']['hinges']} about an end" in words)
    words, of = said("tied_arch", "Units/Force=kN/m", selector="answer")
    ranges = of["ranges"]
    widest = max(e[1] - e[0] for e in [s[d] for s in ranges["reactions"] for d in "xy"] +
                 [link["force"] for link in ranges["links"]])
    expect(words, f"by up to {widest:.4g} kN/m." in words)
    words, of = said("tied_arch", "Ranges/Where=1", selector="answer")
    expect(words, f"{of['ranges']['determined']} of {of['ranges']['interfaces']} joint" in words)
    words, of = said("semicircular_arch", "Ranges/Samples=100", selector="answer")
    expect(words, f"at least {int(of['samples']['effective_number'])} independent" in words)
    words, of = said("shear_wall", "Friction/Strength=0.99999", status=3)
    expect(words, "more work than joints can dissipate, by 1e-05 of it" in words)
    words, of = said("shear_wall", "Friction/Strength=0.5", status=3)
    expect(words, "do 2 times the work" in words)
