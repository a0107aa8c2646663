"""The text of a scene, of lines with the whole names of entries."""


def prm(settings):
    """Lines such as "set Packing/Generator = wall", in their sections."""
    lines = []
    for line in settings.splitlines():
        *sections, entry = line.split(" = ")[0].removeprefix("set ").split("/")
        lines += [f"subsection {section}" for section in sections]
        lines += [f"set {entry} = {line.split(' = ', 1)[1]}"] + ["end"] * len(sections)
    return "\n".join(lines) + "\n"
