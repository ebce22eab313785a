# SPDX-License-Identifier: MIT
"""check_reference.py LOG: prints what Doxygen warned of and is to be mended; fails if there is any.

Without words of their own may be: variables, which their struct explains; functions whose body stands in the header, since
it says what they do; what is moved, and one of several declarations below one comment.
"""
import pathlib
import re
import sys


def speaks_for_itself(file, number, what):
    if "(variable)" in what:
        return True
    lines = [""] + pathlib.Path(file).read_text(encoding="utf-8").split("\n")
    above, declared = lines[number - 1].strip(), ""
    for line in lines[number:number + 12]:
        declared += line
        if re.search(r"[;{]", re.sub(r"\{\}", "", line)):
            break
    if "(function)" in what:
        is_below_another = above.endswith(";") and not above.startswith(("}", "//"))
        return is_below_another or " {" in declared or "&&)" in declared or "= default" in declared
    return "(typedef)" in what and above.endswith(";")


def main():
    to_mend = []
    for line in pathlib.Path(sys.argv[1]).read_text(encoding="utf-8").splitlines():
        found = re.match(r"(.+?):(\d+): \w+: (.*is not documented)", line)
        if not (found and speaks_for_itself(found[1], int(found[2]), found[3])):
            to_mend.append(line)
    print("\n".join(to_mend))
    return bool(to_mend)


if __name__ == "__main__":
    sys.exit(main())
