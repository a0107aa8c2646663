"""What computes the products and factors of dense matrices: OpenBLAS's kernels
for a type of processor, or the reference BLAS.

OpenBLAS chooses its kernels by the processor, or takes those of
OPENBLAS_CORETYPE, which it does not ask whether they can be executed.
"""
import dataclasses
import functools
import os
import pathlib
import re
import subprocess
import sys

# The instructions that kernels are made of, as /proc/cpuinfo names them; types
# of one family differ in the sizes of their blocks, if at all.
AVX512 = {"avx512f", "avx512dq", "avx512bw", "avx512vl", "avx512cd"}
AVX2 = {"avx2", "fma"}
FMA4 = {"avx", "fma4"}
FAMILIES = {
    "AVX-512": {"SkylakeX": AVX512, "Cooperlake": AVX512 | {"avx512_bf16"},
                "SapphireRapids": AVX512 | {"avx512_bf16"}},
    "AVX2": {"Haswell": AVX2, "Zen": AVX2},
    "FMA4": {"Bulldozer": FMA4, "Piledriver": FMA4 | {"fma"},
             "Steamroller": FMA4 | {"fma"}, "Excavator": FMA4 | AVX2},
    "AVX": {"Sandybridge": {"avx"}},
    "SSE": {"Nehalem": {"sse4_2"}, "Penryn": {"sse4_1"},
            "Dunnington": {"sse4_1"}, "Core2": {"ssse3"}, "Atom": {"ssse3"},
            "Barcelona": {"sse4a"}, "Bobcat": {"sse4a"}, "Opteron": {"3dnow"},
            "Opteron_SSE3": {"3dnow"}, "Nano": {"ssse3"},
            "Prescott": {"pni"}}}
# Another type than the processor's own is the first one of another family.
PREFERRED = ("SkylakeX", "Haswell", "Sandybridge", "Prescott")

REFERENCE = "reference"
# Debian's, one library for each soname, to be loaded before any other.
REFERENCE_LIBRARIES = ("blas/libblas.so.3", "lapack/liblapack.so.3")

# Say what OpenBLAS has taken, after the routines that CHOLMOD is made of.
PROBE = """
import ctypes, sys
blas = ctypes.CDLL(sys.argv[1])
blas.openblas_get_corename.restype = ctypes.c_char_p
n = 97
a = (ctypes.c_double * (n * n))(*(float(1 + k % 7) for k in range(n * n)))
for k in range(n):
    a[k * n + k] = 1e3
b, c = (ctypes.c_double * (n * n))(*a), (ctypes.c_double * (n * n))()
size, one = ctypes.byref(ctypes.c_int(n)), ctypes.byref(ctypes.c_double(1))
step = ctypes.byref(ctypes.c_int(1))
blas.dgemm_(b"N", b"T", size, size, size, one, a, size, b, size, one, c, size)
blas.dsyrk_(b"L", b"N", size, size, one, a, size, one, c, size)
blas.dtrsm_(b"R", b"L", b"T", b"N", size, size, one, a, size, c, size)
blas.dgemv_(b"T", size, size, one, a, size, b, step, one, c, step)
blas.dtrsv_(b"L", b"N", b"N", size, a, size, b, step)
print(blas.openblas_get_corename().decode())
"""


@dataclasses.dataclass(frozen=True)
class Kernels:
    """A name, and the environment in which programs take these kernels."""
    name: str
    variables: tuple

    def environment(self):
        """Of a process."""
        return {**os.environ, **dict(self.variables)}


def of_type(name):
    return Kernels(name, (("OPENBLAS_CORETYPE", name),))


def blas_of(program, environment=None):
    """The file that a program loads as its BLAS."""
    listed = subprocess.run(["ldd", program], capture_output=True, text=True,
                            check=True, env=environment).stdout
    found = re.search(r"(\S*/libblas\.so\.3)\b", listed)
    return pathlib.Path(found[1]) if found else None


def name_taken(blas, name):
    """The type that OpenBLAS takes if asked for one, or without a name by
    itself; None if it cannot be executed."""
    environment = {key: value for key, value in os.environ.items()
                   if key != "OPENBLAS_CORETYPE"}
    if name:
        environment["OPENBLAS_CORETYPE"] = name
    done = subprocess.run([sys.executable, "-c", PROBE, blas],
                          capture_output=True, text=True, env=environment)
    return done.stdout.strip() if done.returncode == 0 else None


@functools.cache
def instructions():
    """The flags of this processor."""
    found = re.search(r"^flags\s*:(.*)",
                      pathlib.Path("/proc/cpuinfo").read_text(), re.M)
    return frozenset(found[1].split()) if found else frozenset()


def types(blas):
    """The types that this processor can execute, and that OpenBLAS knows."""
    found = []
    for family in FAMILIES.values():
        for name, needed in family.items():
            if needed <= instructions():
                taken = name_taken(blas, name)
                if taken and taken.lower() == name.lower():
                    found.append(name)
    return found


def family_of(name):
    for family, members in FAMILIES.items():
        if name.lower() in map(str.lower, members):
            return family
    return None


def other_type(blas):
    """One type whose kernels differ from those that OpenBLAS takes here."""
    own = family_of(name_taken(blas, None) or "")
    usable = types(blas)
    for name in PREFERRED:
        if name in usable and family_of(name) != own:
            return name
    return None


def reference(program, blas):
    """The reference BLAS, if it is there and the program takes it."""
    libraries = [blas.parents[1] / name for name in REFERENCE_LIBRARIES]
    if not all(library.exists() for library in libraries):
        return None
    kernels = Kernels(REFERENCE,
                      (("LD_PRELOAD", ":".join(map(str, libraries))),))
    taken = blas_of(program, kernels.environment())
    return kernels if taken == libraries[0] else None
