# SPDX-License-Identifier: MIT
"""python_reference.py FOLDER FILE.md: what `help(penumbra)` says, of the package in FOLDER, as a page; fails where
something public says nothing."""
import inspect
import pathlib
import re
import sys
import textwrap


def head(thing, name):
    """How it is called. Functions of the binding say so in the first line of what they say."""
    try:
        text = f"{name}{inspect.signature(thing)}"
    except (TypeError, ValueError):
        return name
    return re.sub(r"penumbra\._penumbra\.|numpy\.typing\.|typing\.|self, |self|'|: None| -> None", "", text)


def told(thing, name):
    """A function with its docstring, or a class with those of its members."""
    text = inspect.getdoc(thing) or ""
    if not inspect.isclass(thing):
        yield f"{head(thing, name)}\n\n{textwrap.indent(text, '    ')}"
        return
    yield text
    values = []
    for member, value in vars(thing).items():
        if member == "__init__" and (value.__doc__ or "").startswith("__init__("):
            yield re.sub(r"__init__\(self: [\w.]+(, )?(.*)\) -> None", rf"{name}(\2)", value.__doc__.strip())
        elif member.startswith("_"):
            continue
        elif inspect.isfunction(value):
            yield f"{head(value, member)}\n\n{textwrap.indent(inspect.getdoc(value) or '', '    ')}"
        elif isinstance(value, property) and inspect.getdoc(value):
            values.append(f"{member}: {inspect.getdoc(value)}")
        elif isinstance(value, property):
            values.append(member)
    if values:
        yield "Properties:\n" + textwrap.indent("\n".join(values), "    ")


def main():
    sys.path.insert(0, sys.argv[1])
    import penumbra  # pylint: disable=import-outside-toplevel
    page = ["# Python", "", "What `help(penumbra)` says.", "", "```", inspect.getdoc(penumbra), "```", ""]
    silent = []
    for name in sorted(penumbra.__all__, key=str.casefold):
        thing = getattr(penumbra, name)
        if inspect.isclass(thing) or inspect.isroutine(thing):  # else a constant, told by its class
            if not thing.__doc__:
                silent.append(name)
            if inspect.isclass(thing):
                silent += [f"{name}.{member}" for member, value in vars(thing).items()
                           if inspect.isfunction(value) and not member.startswith("_") and not value.__doc__]
            page += [f"## {name}", "", "```", "\n\n".join(told(thing, name)), "```", ""]
    pathlib.Path(sys.argv[2]).write_text("\n".join(page), encoding="utf-8")
    if silent:
        print("without a docstring:", ", ".join(silent))
    return bool(silent)


if __name__ == "__main__":
    sys.exit(main())
