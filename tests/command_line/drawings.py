"""The drawings of prm/ are those that contrib/drawings makes.

    drawings.py SOURCE_DIRECTORY
"""
import filecmp
import os
import subprocess
import sys
import tempfile

SOURCE = sys.argv[1]


def main():
    with tempfile.TemporaryDirectory() as directory:
        subprocess.run([sys.executable, f"{SOURCE}/contrib/drawings", directory], check=True)
        drawn = sorted(os.path.relpath(os.path.join(folder, name), directory)
                       for folder, _, names in os.walk(directory) for name in names)
        different = filecmp.cmpfiles(directory, f"{SOURCE}/prm", drawn, shallow=False)
        if len(drawn) != 8 or different[0] != drawn:
            sys.exit(f"not as in prm/: {different[1] + different[2]}; run contrib/drawings")


if __name__ == "__main__":
    main()
