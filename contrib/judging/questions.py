"""Questions that are asked of each kernel: the scenes of a directory, some of
many cells, and random ones with their load factor and with states."""
import dataclasses
import pathlib

from judging.program import SOLVED
from judging.scenes import Scene, draw_loads

# Only forces are compared.
QUICK = ("Accuracy=draft", "Output/Files=csv", "Output/Report=false")
# Shares of the load factor at which states are asked for.
SHARES = (0.5, 0.99)
# Of the scenes with many cells.
N_MANY = 3000
# A scene whose run takes minutes.
TOO_LARGE = ("million_cells",)


@dataclasses.dataclass(frozen=True)
class Question:
    """A .prm file with settings beside it."""
    name: str
    prm: pathlib.Path
    settings: tuple = ()


def of_directory(directory):
    """The scenes, without pictures and the stress inside blocks."""
    return [Question(prm.stem, prm, QUICK)
            for prm in sorted(directory.glob("*.prm"))
            if prm.stem not in TOO_LARGE]


def of_many_cells(directory):
    """Random cells, so many that CHOLMOD's factors are dense blocks: with a
    load that makes some slide, and up to the limit."""
    tresca = {"Friction/Strength": "0.15"}
    coulomb = {"Friction/Law": "associated Coulomb",
               "Friction/Coefficient": "0.4", "Rotations": "true"}
    deviator = {"Loads/Stress": "-1.2, 0; 0, -0.8"}
    factor = {"Analysis": "load factor", "Loads/Stress": "-1, 0; 0, -1",
              "Live loads/Boundary load": "uniform stress",
              "Live loads/Stress": "-1, 0; 0, 1"}
    prm = directory / "many_cells.prm"
    prm.write_text("")
    for name, entries in {
            "sliding": {**tresca, **deviator}, "factor": {**tresca, **factor},
            "factor_turning": {**coulomb, **factor},
            "no_dilatancy": {**coulomb, **deviator,
                             "Friction/Law": "Coulomb",
                             "Friction/Coefficient": "0.15"}}.items():
        entries = {"Packing/Generator": "Voronoi",
                   "Packing/Voronoi/Number of points": N_MANY,
                   "Loads/Boundary load": "uniform stress", **entries}
        yield Question(f"many_cells_{name}", prm,
                       (*QUICK, *(f"{entry}={value}"
                                  for entry, value in entries.items())))


def without_dilatancy(text):
    return text.replace("set Law = associated Coulomb", "set Law = Coulomb")


def random_questions(program, seed, k):
    """The load factor of a random scene, and states at shares of it; with
    Coulomb's friction the same once more without dilatancy."""
    scene = Scene(seed, k)
    if scene.drawing:
        program.write(f"{scene.name}.wkt", scene.drawing)
    packing = program.run(f"{scene.name}_packing", scene.text())
    if packing.status != SOLVED:
        return
    dead, live = draw_loads(scene, packing.packing()[1])
    texts = {"factor": scene.text(["set Analysis = load factor"], dead, live)}
    run = program.run(f"{scene.name}_factor", texts["factor"])
    factor = run.summary.get("load_factor", {}) if run.status == SOLVED else {}
    if factor and not factor["unbounded"]:
        for share in SHARES:
            texts[f"state_{share}"] = scene.text(
                [], dead.plus(share * factor["carried"], live))
    if scene.law != "Tresca":
        texts.update({f"{name}_no_dilatancy": without_dilatancy(text)
                      for name, text in texts.items()})
    for name, text in texts.items():
        prm = program.directory / f"{scene.name}_{name}.prm"
        prm.write_text(text)
        yield Question(prm.stem, prm)
