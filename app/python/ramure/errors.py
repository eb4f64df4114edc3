"""What goes wrong."""


class Error(Exception):
    """What Ramure refuses, or what the system refused it, and where.

    reason  why, in a sentence
    code    "invalid", "syntax", "limit", "io", "version", "unknown" or "cancelled"
    file    the file concerned, or ""
    path    the place inside: a parameter's key, a path of JSON, or ""
    line    from 1 on, or 0
    column  from 1 on, or 0
    """

    __module__ = "ramure"

    def __init__(self, reason: str, code: str = "invalid", file: str = "", path: str = "", line: int = 0,
                 column: int = 0):
        super().__init__(reason, code, file, path, line, column)
        self.reason, self.code, self.file, self.path, self.line, self.column = reason, code, file, path, line, column

    def __str__(self) -> str:
        numbers = ":".join(str(n) for n in (self.line, self.column) if n > 0)
        place = ":".join(part for part in (self.file, numbers) if part)
        return ": ".join(part for part in (place, self.path, self.reason) if part)
