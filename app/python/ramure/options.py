"""Keywords of Python as options of the command line."""
from __future__ import annotations

import difflib
import os
from typing import Any, Dict, List, Tuple

from . import _ramure

_options: Dict[str, Tuple[bool, str]] = {name: (takes, text) for name, takes, text in _ramure.export_options()}


def export_options() -> Dict[str, str]:
    """The keywords of Tree.export() with their help, which is that of `ramure-cli export`."""
    return {name.replace("-", "_"): text for name, (_, text) in _options.items()}


def near(name: str, names) -> str:
    """", did you mean A or B?" of names that look like one."""
    found = difflib.get_close_matches(name, list(names), 3, 0.5)
    if not found:  # difflib minds capitals
        small = {each.lower(): each for each in names}
        found = [small[each] for each in difflib.get_close_matches(name.lower(), small, 3, 0.5)]
    return f": did you mean {' or '.join(found)}?" if found else ""


def text(value: Any) -> str:
    """A value as the command line has it: lists with commas between, ranges as FIRST:LAST:STEP."""
    if isinstance(value, range):
        if len(value) == 0 or value.step < 1:
            raise TypeError("a range of frames has to rise")
        return f"{value[0]}:{value[-1]}:{value.step}"
    if isinstance(value, (list, tuple)):
        return ",".join(text(each) for each in value)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, bool) or not isinstance(value, (str, int, float)) and not hasattr(value, "__float__"):
        raise TypeError(f"{value!r}: a text, a number or a list of them expected")
    return value if isinstance(value, str) else repr(value) if isinstance(value, (int, float)) else repr(float(value))


def words(options: Dict[str, Any]) -> List[bytes]:
    """Raises TypeError for an option that there is not, or whose value is of no use."""
    out: List[str] = []
    for key, value in options.items():
        name = key.replace("_", "-")
        if name not in _options:
            raise TypeError(f"there is no option {key!r}" + near(key, export_options()))
        takes, _ = _options[name]
        if value is None or value is False:
            continue
        if not takes:
            if value is not True:
                raise TypeError(f"{key} is switched on with True, not {value!r}")
            out.append("--" + name)
            continue
        try:
            several = value if name == "node" and isinstance(value, (list, tuple)) else [value]
            out += [f"--{name}={text(each)}" for each in several]
        except TypeError as problem:
            raise TypeError(f"{key}: {problem}") from None
    return [os.fsencode(word) for word in out]
