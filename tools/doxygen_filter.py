# SPDX-License-Identifier: MIT
"""doxygen_filter.py HEADER: the header as Doxygen wants it, on standard output, line by line.

What a header's head says of it becomes the text of its page, and so do C's comments of what they stand before or behind.
"""
import pathlib
import re
import sys


def of_c(text):
    text = re.sub(r"^(\s*)/\* --- (.*?) --- \*/", r"\1/* \2 */", text, flags=re.MULTILINE | re.DOTALL)
    lines, in_head = [], True
    for line in text.split("\n"):
        if in_head and line.startswith("/*") and "SPDX" not in line:
            line, in_head = line.replace("/*", "/** @file\n *", 1), False
        else:
            line = re.sub(r"^(\s*)/\* ", r"\1/** ", line)
            line = re.sub(r"(?<=[;,{0-9]) /\* (.*)", r" /**< \1", line)
        lines.append(line)
    return "\n".join(lines)


def of_cpp(text):
    lines, in_head = [], False
    for number, line in enumerate(text.split("\n")):
        if number == 1 and line.startswith("//"):
            lines.append("/// @file")
            in_head = True
        if in_head and line.startswith("//"):
            line = "/" + line
        else:
            in_head = False
        lines.append(line)
    return "\n".join(lines)


if __name__ == "__main__":
    header = pathlib.Path(sys.argv[1])
    source = header.read_text(encoding="utf-8")
    is_code = header.suffix == ".h"
    print((of_c if header.name.endswith("_c.h") else of_cpp)(source) if is_code else source, end="")
