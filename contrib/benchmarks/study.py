#!/usr/bin/python3
"""Measure what the settings of voussoir cost and how accurate they are.

Writes DIR/accuracy.md, a page of advice and plots, with the tables in
DIR/accuracy/*.md and *.csv and the plots in DIR/images/accuracy_*.png. The program must
have been built; contrib/study does that first. The full study takes an hour.
"""
import sys

from command import Study, missing

try:
    import features
    import forces
    import page
    import space
    import stress
    from runs import Bench
except ImportError as error:
    sys.exit(missing("study.py", error))

STUDY = Study("contrib/study",
              {"formulations": forces.formulations,
               "tolerance": forces.tolerance,
               "barrier": forces.barrier,
               "reconstruction": stress.reconstruction,
               "rigidity": forces.rigidity,
               "features": features.features,
               "factors": space.factors,
               "friction_cells": space.friction_cells,
               "questions": space.questions,
               "space_stress": space.space_stress,
               "extruded": space.extruded},
              "accuracy", 5, "build/study")


def main():
    options = STUDY.options(STUDY.parser(__doc__))
    if not options.page_only:
        with Bench(options.program.resolve(), options.repeats,
                   options.quick) as bench:
            STUDY.measure(options, bench)
    print(f"The page is {page.write(options.output)}")


if __name__ == "__main__":
    main()
