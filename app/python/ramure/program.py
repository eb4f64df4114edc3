"""The program beside the package."""
import re
import shutil
import subprocess

from .errors import Error
from .version import __version__


def check_program(path: str = "ramure-cli") -> str:
    """Where ramure-cli is. Raises Error where there is none, or one of another version: its trees may differ."""
    found = shutil.which(path)
    if not found:
        raise Error(f"there is no program {path}", "io", path)
    try:
        said = subprocess.run([found, "--version"], capture_output=True, text=True, timeout=20, check=False).stdout
    except (OSError, subprocess.TimeoutExpired) as problem:
        raise Error(f"it does not answer: {problem}", "io", found) from problem
    match = re.search(r"^ramure-cli (\d+\.\d+\.\d+)$", said, re.MULTILINE)
    if not match:
        raise Error("this is not ramure-cli", "invalid", found)
    if match.group(1) != __version__:
        raise Error(f"the program is version {match.group(1)}, this module {__version__}: the same numbers may give other "
                    "trees", "version", found)
    return found
