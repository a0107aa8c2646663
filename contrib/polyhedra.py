"""Blocks as vertices and faces, for drawings and judged scenes."""


def prism(low, high):
    """The vertices and faces between two polygons, which look along from low to high."""
    n = len(low)
    sides = [[i, (i + 1) % n, n + (i + 1) % n, n + i] for i in range(n)]
    return low + high, [list(range(n))[::-1], list(range(n, 2 * n))] + sides


def along_x(polygon, start, end):
    """A prism over a polygon of (y, z), counterclockwise as seen from above x."""
    return prism([(start, *p) for p in polygon], [(end, *p) for p in polygon])


def box(low, high):
    return prism(*([(low[0], low[1], z), (high[0], low[1], z), (high[0], high[1], z),
                    (low[0], high[1], z)] for z in (low[2], high[2])))


def facade(n_bricks, n_behind, n_courses):
    """A facade and two walls behind it, of bricks 2 x 1 x 1 that interlock at the
    corners; each with the name of its group."""
    blocks, length, depth = [], 2 * n_bricks, 2 * n_behind
    for k in range(n_courses):
        shift = k % 2
        blocks += [("facade", box((x, 0, k), (x + 2, 1, k + 1)))
                   for x in range(shift, length - shift, 2)]
        blocks += [("walls", box((x, y, k), (x + 1, min(y + 2, depth), k + 1)))
                   for x in (0, length - 1) for y in range(1 - shift, depth, 2)]
    return blocks


def obj_text(blocks):
    """An .obj file of named blocks, each an object of its own."""
    lines, first = [], 1
    for group, (vertices, faces) in blocks:
        lines.append(f"o {group}")
        lines += ["v " + " ".join(f"{x:.15g}" for x in vertex) for vertex in vertices]
        lines += ["f " + " ".join(str(first + v) for v in face) for face in faces]
        first += len(vertices)
    return "\n".join(lines) + "\n"
