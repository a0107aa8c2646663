#!/usr/bin/python3
"""Measure voussoir beside other solvers, and what large packings cost.

Writes DIR/cost.md, a page of tables and plots, with the tables in
DIR/cost/*.csv and the plots in DIR/images/cost_*.png. The program must have
been built; contrib/cost does that first. The full measurement takes four hours;
nothing else should run beside it.
"""
import math
import sys

from command import Study, missing

try:
    import cost_page
    import growth
    import kernels
    import peers
    import sliding
    from runs import TIME_LIMIT, Bench
except ImportError as error:
    sys.exit(missing("cost.py", error))

STUDY = Study("contrib/cost",
              {"forms": peers.forms, "peers": peers.peers,
               "sliding": sliding.sliding, "growth": growth.growth,
               "sliding_growth": growth.sliding_growth,
               "kernels": kernels.kernels},
              "cost", 3, "build/cost")


def main():
    parser = STUDY.parser(__doc__)
    parser.add_argument("--time-limit", type=int, metavar="SECONDS",
                        help=f"of each run: {TIME_LIMIT}, or 60 with --quick")
    parser.add_argument("--largest", type=int, default=math.inf,
                        metavar="CELLS", help="no larger packings")
    options = STUDY.options(parser)
    usual = 60 if options.quick else TIME_LIMIT
    limit = options.time_limit or usual
    extra = (f" --time-limit {limit}" * (limit != usual) +
             f" --largest {options.largest}" * (options.largest < math.inf))
    if not options.page_only:
        with Bench(options.program.resolve(), options.repeats, options.quick,
                   limit, options.largest) as bench:
            STUDY.measure(options, bench, extra, peers.versions())
    print(f"The page is {cost_page.write(options.output)}")


if __name__ == "__main__":
    main()
