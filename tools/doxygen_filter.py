# SPDX-License-Identifier: MIT
"""doxygen_filter.py HEADER: the header as Doxygen wants it, on standard output, line by line.

What a header's head says of it becomes the text of its page, and C's comments that of what they stand before or
behind.
"""
import pathlib
import re
import sys


def of_c(text):
    text = re.sub(r"^/\* SPDX.*\n/\*", "/** @file\n *", text)
    text = re.sub(r"^ \*   (?=\S)", " *     ", text, flags=re.MULTILINE)  # Markdown's code
    text = re.sub(r"^/\* --- (\w.*\..*\n(?:.*\n)??.*) --- \*/", r"/* \1 */", text, flags=re.MULTILINE)  # says something
    text = re.sub(r"^(\s*)/\* (?!---)", r"\1/** ", text, flags=re.MULTILINE)
    return re.sub(r"(?<=[;,{0-9]) /\* ", " /**< ", text)


def of_cpp(text):
    head = re.match(r"// SPDX.*\n((?://.*\n)*)", text)
    told = re.sub(r"^//(   (?=\S))?", lambda match: "///     " if match[1] else "///", head[1], flags=re.MULTILINE)
    namespace = "/** @namespace penumbra All of it. */ " if "The whole of" in told else ""
    return f"{namespace}/// @file\n" + told + text[head.end():]


if __name__ == "__main__":
    header = pathlib.Path(sys.argv[1])
    source = header.read_text(encoding="utf-8")
    is_code = header.suffix == ".h"
    print((of_c if header.name.endswith("_c.h") else of_cpp)(source) if is_code else source, end="")
