"""Experiments on load factors, and on blocks in space: functions from a Bench
to the rows of a table."""
import numpy as np

import space_fields
import space_scenes as scenes
from common import USUAL_TOLERANCE as USUAL
from common import ending, picked, statics, times
from measures import columns
from scenes import FORCES_ONLY, random_cells


def sideways(scene):
    """The factor of the live loads is asked for."""
    return {**scene, "Analysis": "load factor"}


def structures(bench):
    """Structures in the plane and in space, by name."""
    cells, grains = bench.sized((1000, 300), (50, 10))
    courses, bricks = bench.sized((20, 10), (4, 3))
    return {
        f"plane: {cells} random cells":
            {**random_cells(cells, 0), **FORCES_ONLY,
             "Live loads/Boundary load": "uniform stress",
             "Live loads/Stress": "-1, 0; 0, 1",
             "Formulation": "least energy"},
        f"plane: wall, {courses} x {bricks} bricks":
            {**scenes.wall_in_plane(courses, bricks), **FORCES_ONLY},
        f"space: {grains} random cells":
            {**scenes.grains(grains, "false"), **scenes.NO_STRESS},
        f"space: {grains} random cells that turn":
            {**scenes.grains(grains, "true"), **scenes.NO_STRESS},
        f"space: wall, {courses} x {bricks} bricks":
            {**scenes.wall(courses, bricks), **scenes.NO_STRESS},
        f"space: dome, {courses} courses":
            {**scenes.dome(courses, 2 * courses), **scenes.NO_STRESS}}


def factors(bench):
    """The load factor by its tolerance: the width between the proofs."""
    tolerances = bench.sized((1e-1, 1e-2, 1e-3, 1e-4, 1e-6, USUAL, 1e-10),
                             (1e-2, USUAL))
    rows = []
    for name, scene in structures(bench).items():
        outcomes = bench.series(
            "factors",
            [({"structure": name, "tolerance": tolerance},
              {**sideways(scene),
               "Solver/Tolerance of the load factor": tolerance})
             for tolerance in tolerances], factor)
        reference = picked(outcomes, tolerance=USUAL)
        for outcome in outcomes:
            seen = outcome.seen or {}
            rows.append({
                **outcome.labels, **times(outcome, reference),
                **ending(outcome), "carried": seen.get("carried", ""),
                "width": seen.get("width", "")})
    return rows


def factor(run):
    """What the summary of a run says of its load factor."""
    return run.summary["load_factor"]


def friction_cells(bench):
    """Joints with Tresca's strength in space by `Friction cells`: the proofs of
    the continuous face, the factor that is carried and the bound."""
    by_name = {
        "column in torsion": scenes.twisted_column(8, 12),
        "wall pushed at an end": scenes.wall_pushed_at_an_end(
            *bench.sized((8, 4), (3, 3))),
        "dome": scenes.cohesive(
            scenes.dome(*bench.sized((8, 12), (3, 5))), 4)}
    rows = []
    for name, scene in by_name.items():
        outcomes = bench.series(
            "friction_cells",
            [({"structure": name, "friction_cells": cells},
              {**sideways(scene), **scenes.NO_STRESS,
               "Contact/Friction cells": cells})
             for cells in bench.sized((1, 2, 3, 4, 6, 8), (1, 2))], factor)
        for outcome in outcomes:
            seen = outcome.seen or {}
            bound = seen.get("bound_of_continuous_faces", "")
            carried = seen.get("carried", "")
            rows.append({
                **outcome.labels, **times(outcome, outcomes[0]),
                **ending(outcome), "carried": carried, "bound": bound,
                "bracket": bound / carried - 1 if bound != "" else ""})
    return rows


def questions(bench):
    """What each question costs beside the state of least energy."""
    courses, bricks = bench.sized((20, 10), (4, 3))
    dome = bench.sized((12, 20), (3, 5))
    in_plane = {**scenes.wall_in_plane(courses, bricks), **FORCES_ONLY}
    in_space = {**scenes.dome(*dome), **scenes.NO_STRESS}
    by_name = {
        f"plane: wall, {courses} x {bricks} bricks":
            (in_plane, "abs(y - 0.25) < 1e-9",
             "x > 1.25 ? 0 : 0.01; 0"),
        f"space: dome, {dome[0]} x {dome[1]} blocks":
            (in_space, "z < 0.2 && x > 0.7",
             "x > 0 ? 0.01 : 0; 0; 0")}
    rows = []
    for name, (scene, where, settlement) in by_name.items():
        state = without_live_loads(scene)
        asked = {
            "state of least energy": state,
            "load factor": sideways(scene),
            "strength factor": {**sideways(state), "Load factor/Factor":
                                "strength"},
            "ranges of the reactions": {**state, "Ranges/Reactions": "true"},
            "ranges of some joints": {**state, "Ranges/Where": where},
            "settlement": {**state, "Supports/Displacement": settlement}}
        outcomes = bench.series(
            "questions",
            [({"structure": name, "question": question}, parameters)
             for question, parameters in asked.items()], lambda run: run)
        for outcome in outcomes:
            rows.append({**outcome.labels,
                         **times(outcome, outcomes[0], whole),
                         **ending(outcome),
                         "cells": outcome.runs[0].summary.get(
                             "packing", {}).get("cells", "")})
    return rows


def whole(run):
    """The seconds of all that is asked, without the packing and the files."""
    seconds = sum(value for stage, value in run.stages.items()
                  if stage not in ("packing", "output", "stress"))
    return seconds if run.stages else run.elapsed


def extruded(bench):
    """Structures in the plane and the same extruded in space: the time, and
    the difference of what was found."""
    walls = bench.sized(((10, 5), (20, 10), (40, 20)), ((3, 3),))
    arches = bench.sized((27, 200), (7,))
    pairs = {**{f"wall, {c} x {b} bricks":
                (scenes.wall_in_plane(c, b), scenes.wall(c, b))
                for c, b in walls},
             **{f"arch, {n} voussoirs":
                (scenes.arch_in_plane(n), scenes.arch(n)) for n in arches}}
    rows = []
    for name, of_both in pairs.items():
        for question in ("state", "load factor"):
            asked = [{**(sideways(scene) if question == "load factor" else
                         cemented(scene)), **more}
                     for scene, more in zip(of_both, (FORCES_ONLY,
                                                      scenes.NO_STRESS))]
            outcomes = bench.series(
                "extruded",
                [({"structure": name, "question": question,
                   "dimension": dimension}, scene)
                 for dimension, scene in zip((2, 3), asked)], what_was_found)
            flat, solid = outcomes
            both = flat.seen is not None and solid.seen is not None
            rows.append({
                **{key: value for key, value in solid.labels.items()
                   if key != "dimension"},
                "plane_seconds": np.median([statics(run) for run in flat.runs]),
                **times(solid, flat), **ending(solid),
                "difference": difference(flat.seen, solid.seen) if both else ""})
    return rows


def cemented(scene):
    """The state with joints that do not slide. That of Coulomb's friction is
    chosen in another way in the plane."""
    return without_live_loads(scenes.cohesive(scene, 300))


def without_live_loads(scene):
    return {key: value for key, value in scene.items()
            if not key.startswith("Live loads")}


def what_was_found(run):
    """The factor, or the normal forces of all joints in their order."""
    if "load_factor" in run.summary:
        return np.array([run.summary["load_factor"]["carried"]])
    return np.sort(columns(run.directory / "interfaces.csv",
                           ["normal_force"])["normal_force"])


def difference(plane, space):
    """The largest difference over the largest value, per thickness."""
    if len(space) > 1:
        space = space / scenes.THICKNESS
    return np.abs(space - plane).max() / np.abs(plane).max()


def space_stress(bench):
    """The stress inside one block against closed forms, by its size."""
    shapes = {"cube": scenes.cube(), "dodecahedron": scenes.dodecahedron()}
    rows = []
    for shape, (vertices, faces) in shapes.items():
        for size in bench.sized((0.4, 0.2, 0.1, 0.05, 0.025), (0.2, 0.1)):
            placed = size * vertices + space_fields.PLACE
            model = bench.scratch / "block.obj"
            write_obj(model, placed, faces)
            for name in space_fields.FIELDS:
                rows += errors_of(bench, shape, size, name, model, placed,
                                  faces)
    return rows


def errors_of(bench, shape, size, name, model, vertices, faces):
    """The rows of one block under one field."""
    def see(run):
        return space_fields.distance(name, run.directory, vertices, faces)

    outcomes = bench.series(
        "space_stress",
        [({"shape": shape, "inradius": size, "field": name,
           "accuracy": accuracy},
          {**scenes.SPACE, "Rotations": "true", "Packing/Generator": "model",
           "Packing/model/File": model, **space_fields.loads(name),
           **scenes.NO_STRESS, "Accuracy": accuracy})
         for accuracy in ("draft", "standard", "fine")], see, repeats=1)
    rows = []
    for outcome in outcomes:
        distance, of_mean = outcome.seen or ("", "")
        rows.append({**outcome.labels, "outcome": outcome.outcome,
                     "distance": distance, "distance_of_means": of_mean})
    return rows


def write_obj(path, vertices, faces):
    """Write one polyhedron, with all digits: which of the cuts of its faces that
    are as good as others `standard` takes depends on the last ones."""
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in vertices.tolist()]
    lines += ["f " + " ".join(str(v + 1) for v in face) for face in faces]
    path.write_text("\n".join(lines) + "\n")
