"""The version of the package; that of the library beside it has to be the same."""
__version__ = "0.2.0"
