# SPDX-License-Identifier: MIT
"""check_reference.py LOG PAGES: prints what Doxygen warned of and is to be mended, and links of the pages that lead
nowhere; fails if there is any.

Without words of their own may be: variables, which their struct explains; functions whose body stands in the header,
since it says what they do; what is moved, and one of several declarations below one comment.
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


def dead_links(folder):
    pages = {path.name: path.read_text(encoding="utf-8") for path in folder.glob("*.html")}
    for name, page in pages.items():
        for link in set(re.findall(r'href="((?!https?:|javascript:)[^"]+)"', page)):
            file, _, place = link.partition("#")
            target = pages.get(file or name)
            is_there = target is not None or (folder / file).exists()
            if not is_there or (place and f'id="{place}"' not in target and f'name="{place}"' not in target):
                yield f"{name}: a link to {link}"


def main():
    to_mend = list(dead_links(pathlib.Path(sys.argv[2])))
    for line in pathlib.Path(sys.argv[1]).read_text(encoding="utf-8").splitlines():
        found = re.match(r"(.+?):(\d+): \w+: (.*is not documented)", line)
        if not (found and speaks_for_itself(found[1], int(found[2]), found[3])):
            to_mend.append(line)
    print("\n".join(to_mend))
    return bool(to_mend)


if __name__ == "__main__":
    sys.exit(main())
