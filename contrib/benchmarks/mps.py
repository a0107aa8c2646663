"""Linear programs as files in MPS format."""
import numpy as np


def write_mps(path, program):
    """Write a LinearProgram with all digits, in free format. Rows are R0, R1,
    ..., columns C0, C1, ..."""
    matrix = program.matrix
    kind = "E" if program.equal else "G"
    with open(path, "w", encoding="ascii") as file:
        file.write("NAME packing FREE\nROWS\n N cost\n")
        file.writelines(f" {kind} R{i}\n" for i in range(matrix.shape[0]))
        file.write("COLUMNS\n")
        starts, rows = matrix.indptr.tolist(), matrix.indices.tolist()
        values = matrix.data.tolist()
        for j, cost in enumerate(program.cost.tolist()):
            if cost:
                file.write(f" C{j} cost {cost!r}\n")
            file.writelines(f" C{j} R{rows[k]} {values[k]!r}\n"
                            for k in range(starts[j], starts[j + 1]))
        file.write("RHS\n")
        file.writelines(f" RHS R{i} {value!r}\n"
                        for i, value in enumerate(program.right.tolist())
                        if value)
        file.write("BOUNDS\n")
        file.writelines(map(bound, range(matrix.shape[1]),
                            program.lower.tolist(), program.upper.tolist()))
        file.write("ENDATA\n")


def bound(j, lower, upper):
    """The lines of the bounds of a column; the default is zero and none."""
    if lower == -np.inf:
        return f" FR BND C{j}\n"
    return ((f" LO BND C{j} {lower!r}\n" if lower else "") +
            (f" UP BND C{j} {upper!r}\n" if upper < np.inf else ""))
