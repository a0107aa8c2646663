"""Makes the pictures of doc/images; started by contrib/pictures."""
import argparse
import os
import subprocess
import sys
import tempfile

import render

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

# The selections, beside each other in the pictures of the paper's tests.
CONTACT = "Solver/smoothed friction/Contact="
BARRIER = "Solver/analytic centre/Barrier weights="
SELECTIONS = {
    "smoothed friction, compliant": ("Formulation=smoothed friction",
                                     CONTACT + "compliant"),
    "smoothed friction, hard": ("Formulation=smoothed friction", CONTACT + "hard"),
    "linear program": ("Formulation=linear program",),
    "least energy": ("Formulation=least energy",),
    "analytic centre, edge area": ("Formulation=analytic centre",
                                   BARRIER + "edge area"),
    "analytic centre, equal": ("Formulation=analytic centre", BARRIER + "equal")}
ALL = tuple(SELECTIONS.values())
SIX = ("--titles", "; ".join(SELECTIONS))
OWN = ((),)  # as the scene is
LOW = "Friction/Strength="
PUSH = "Loads/Body force=4; -20"
VAULT = "Packing/vault/"
POINTED = (VAULT + "Shape=pointed", VAULT + "Abutments=4", VAULT + "Length=0.4",
           VAULT + "Blocks per row=1", VAULT + "Bond=stack",
           "Supports/Where=nz < -0.99 && z < -0.9")
OCULUS = ("Packing/dome/Crown=oculus", "Packing/dome/Embrace=140",
          "Packing/dome/Sectors=16", "Supports/Where=nz < -0.5 && z < 0.35")

# Name of the picture, scene of prm/, settings of each panel, view, and options of
# render.py. This is the one place where pictures are defined.
PICTURES = [
    ("verification_1", "verification_1", ALL, "resultants", SIX),
    ("verification_2", "verification_2", ALL, "resultants", SIX),
    ("shear_wall_selections", "shear_wall", ALL, "sigma_xy",
     (*SIX, "--limit", "2")),
    ("shear_wall", "shear_wall", OWN, "sigma_xy", ()),
    ("shear_wall_collapse", "shear_wall", ((LOW + "0.9",),), "mechanism", ()),
    ("shear_wall_ranges", "shear_wall", (("Ranges/Where=1",),), "ranges", ()),
    ("homogeneous_compression", "homogeneous_compression", ALL, "sigma_xx",
     (*SIX, "--limit", "4")),
    ("homogeneous_compression_chains", "homogeneous_compression", ALL, "chains",
     (*SIX, "--limit", "0.4", "--width", "720")),
    ("homogeneous_compression_hard", "homogeneous_compression",
     ((CONTACT + "hard",),), "sigma_xx", ("--limit", "4")),
    ("wall_with_openings", "wall_with_openings", OWN, "sigma_yy", ("--limit", "120")),
    ("wall_with_openings_loads", "wall_with_openings", OWN, "loads", ()),
    ("wall_with_openings_chains", "wall_with_openings", OWN, "chains", ()),
    ("arch", "arch", OWN, "sigma_yy", ()),
    ("arch_chains", "arch", OWN, "chains", ()),
    ("arch_utilisation", "arch", OWN, "utilisation", ()),
    ("arch_collapse", "arch", ((LOW + "12.9",),), "mechanism", ()),
    ("semicircular_arch_thrust", "semicircular_arch", OWN, "thrust", ()),
    ("semicircular_arch_eccentricity", "semicircular_arch", OWN, "eccentricity", ()),
    ("semicircular_arch_collapse", "semicircular_arch",
     (("Packing/arch/Thickness=0.107457",),), "mechanism", ()),
    ("pointed_vault", "pointed_vault", OWN, "sigma_yy", ()),
    ("pointed_vault_principal", "pointed_vault", OWN, "principal", ()),
    ("retaining_wall", "retaining_wall", OWN, "sigma_xy", ("--width", "500")),
    ("retaining_wall_principal", "retaining_wall", OWN, "principal",
     ("--width", "500")),
    ("retaining_wall_collapse", "retaining_wall", ((LOW + "22",),), "mechanism",
     ("--width", "500")),
    ("rocking_column_collapse", "rocking_column",
     (("Loads/Body force=4.01; -20",),), "mechanism", ("--width", "350")),
    ("spreading_arch", "spreading_arch", OWN, "mechanism", ()),
    ("spreading_arch_thrust", "spreading_arch", OWN, "thrust", ()),
    ("dry_arch_collapse", "dry_arch", OWN, "mechanism", ()),
    ("arch_bridge_collapse", "arch_bridge", OWN, "mechanism", ()),
    ("ferris_tin_loi_1_collapse", "ferris_tin_loi_1", OWN, "mechanism", ()),
    ("two_span_bridge_collapse", "two_span_bridge", OWN, "mechanism", ()),
    ("two_ring_arch_collapse", "two_ring_arch", OWN, "mechanism", ()),
    ("facade_collapse", "facade", OWN, "mechanism", ()),
    ("sinking_pier_chains", "sinking_pier", OWN, "chains", ()),
    ("buttress_collapse", "buttress", OWN, "mechanism", ("--width", "500")),
    ("dry_stone_wall_collapse", "dry_stone_wall", OWN, "mechanism", ("--width", "500")),
    ("portal_thrust", "portal", OWN, "thrust", ("--width", "600")),
    ("gateway_collapse", "gateway", OWN, "mechanism", ("--width", "600")),
    ("rubble_wall", "rubble_wall", OWN, "sigma_yy", ()),
    ("rubble_wall_blocks", "rubble_wall", OWN, "blocks", ()),
    ("graded_hexagon", "graded_hexagon", OWN, "chains", ("--width", "700")),
    ("graded_hexagon_principal", "graded_hexagon", OWN, "principal",
     ("--width", "700")),
    ("million_cells", "million_cells",
     (("Packing/Voronoi/Number of points=1000", LOW + "0.16"),), "utilisation",
     ("--width", "700")),
    ("tutorial_stress", "tutorial_wall", OWN, "principal", ()),
    ("tutorial_turning", "tutorial_wall",
     (("Rotations=true", "Loads/Body force=13.5; -20", LOW + "1000"),), "mechanism",
     ()),
    ("tutorial_utilisation", "tutorial_wall", ((), (PUSH,)), "utilisation",
     ("--titles", "weight; weight and push")),
    ("tutorial_mechanism", "tutorial_wall", ((PUSH, LOW + "10.09"),), "mechanism",
     ()),
    ("tutorial_dome", "space/dome",
     (("Analysis=state", "Packing/dome/Thickness=0.05", "Packing/dome/Bond=stack"),), "joints",
     ("--width", "700")),
    ("tutorial_dome_mechanism", "space/dome",
     (("Analysis=state", "Packing/dome/Thickness=0.042", "Packing/dome/Bond=stack"),),
     "mechanism",
     ("--cut=y < 0", "--width", "700")),
    ("tutorial_model", "space/models/oculus_dome", OWN, "blocks",
     ("--from=1,-2,1.2", "--apart", "0.1", "--width", "700")),
    ("space_wall", "space/wall", OWN, "blocks", ("--from=1,-2,1", "--cut=x > 2.74")),
    ("space_building", "space/building", OWN, "blocks",
     ("--from=1,-1.5,1", "--width", "700")),
    ("space_building_mechanism", "space/building", OWN, "mechanism",
     ("--from=1,-1.5,1", "--fraction", "0.8", "--width", "700")),
    ("space_building_trajectories", "space/building", (("Analysis=state",),),
     "trajectories", ("--from=1,-1.5,1", "--width", "700")),
    ("space_columns", "space/columns", OWN, "blocks",
     ("--from=1,-2,0.7", "--width", "600")),
    ("space_stairs", "space/stairs", OWN, "blocks",
     ("--from=-1,-1.5,1", "--width", "700")),
    ("space_barrel_vault", "space/barrel_vault", OWN, "blocks",
     ("--from=1,-1.5,1", "--apart", "0.2", "--width", "700")),
    ("space_barrel_vault_stress", "space/barrel_vault", (("Analysis=state",),),
     "principal_stress_min", ("--from=1,-1.5,0.6", "--width", "700")),
    ("space_pointed_arch", "space/barrel_vault", (POINTED,), "blocks",
     ("--from=1,-2,0.7", "--width", "500")),
    ("space_dome", "space/dome", OWN, "blocks", ("--width", "700")),
    ("space_dome_joints", "space/dome", OWN, "joints", ("--width", "700")),
    ("space_dome_crosses", "space/dome", (("Analysis=state",),), "principal",
     ("--width", "700")),
    ("space_dome_trajectories", "space/dome", (("Analysis=state",),), "trajectories",
     ("--width", "700")),
    ("space_dome_oculus", "space/dome", (OCULUS,), "blocks",
     ("--from=1,-2,1", "--cut=y < 0")),
    ("space_cross_vault", "space/cross_vault", OWN, "volume", ("--width", "700")),
    ("space_cross_vault_apart", "space/cross_vault", OWN, "volume",
     ("--apart", "0.5", "--width", "700")),
    ("space_grains", "space/grains", OWN, "volume",
     ("--cut=y < 0.5", "--width", "600")),
    ("space_groove", "space/groove", OWN, "blocks",
     ("--from=-1.5,-1,1", "--width", "500")),
    ("space_rock_wedge", "space/rock_wedge", OWN, "blocks",
     ("--from=1,-2,1", "--width", "500")),
    ("space_facade", "space/facade", OWN, "blocks",
     ("--from=-1,-2,1", "--apart", "0.15", "--width", "600")),
    ("space_bridge", "space/models/bridge", OWN, "blocks",
     ("--from=1,-2.5,1", "--apart", "0.15")),
    ("space_snake", "space/models/snake", OWN, "blocks",
     ("--from=1,-2.5,1", "--width", "700")),
    ("space_curved_wall", "space/models/curved_wall", OWN, "blocks",
     ("--from=-1,-2,1.2",)),
    ("space_oculus_dome", "space/models/oculus_dome", OWN, "blocks",
     ("--from=1,-2,1.2", "--cut=y < -0.5")),
    ("space_tessellation", "space/models/tessellation", OWN, "volume",
     ("--apart", "0.3", "--width", "600")),
]


def parse():
    parser = argparse.ArgumentParser(
        prog="contrib/pictures", description="Makes the pictures of doc/images.")
    parser.add_argument("--program", metavar="PATH",
                        help="a built voussoir; by default it is built first")
    parser.add_argument("--only", nargs="+", metavar="NAME",
                        help="of the pictures: " + ", ".join(p[0] for p in PICTURES))
    parser.add_argument("--output", metavar="DIRECTORY",
                        default=os.path.join(TOP, "doc", "images"))
    options = parser.parse_args()
    for name in options.only or ():
        if name not in [picture[0] for picture in PICTURES]:
            parser.error(f"there is no picture '{name}'")
    if not options.program:
        parser.error("--program is needed; contrib/pictures gives it")
    if not os.access(options.program, os.X_OK):
        parser.error(f"there is no program '{options.program}'")
    if not os.path.isdir(options.output):
        parser.error(f"there is no directory '{options.output}'")
    return options


def run(program, scene, settings, directory):
    """The results of a scene, in the directory; a collapse is a result too."""
    command = [program, os.path.join(TOP, "prm", scene + ".prm"),
               "--set", "Output directory=" + directory]
    for setting in settings:
        command += ["--set", setting]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in (0, 3):
        sys.exit(f"contrib/pictures: {' '.join(command)}: {done.stderr}")


def main():
    options = parse()
    directories = {}  # of what has been run
    with tempfile.TemporaryDirectory(prefix="voussoir-pictures-") as results:
        for name, scene, panels, view, extra in PICTURES:
            if options.only and name not in options.only:
                continue
            print(name, flush=True)
            for settings in panels:
                if (scene, settings) not in directories:
                    directory = os.path.join(results, str(len(directories)))
                    run(options.program, scene, settings, directory)
                    directories[scene, settings] = directory
            status = render.main([view, *extra,
                                  os.path.join(options.output, name + ".png"),
                                  *(directories[scene, s] for s in panels)])
            if status:
                sys.exit(status)


if __name__ == "__main__":
    main()
