"""The recipe of a tree: the source that it begins with, and the steps behind it."""
from __future__ import annotations

import json
from typing import Any, Iterator, List, Mapping, Optional, Union

from . import _ramure
from .errors import Error

_kinds = {entry["kind"]: entry for entry in _ramure.step_kinds()}


def step_kinds() -> List[dict]:
    """All kinds of steps, with "kind", "group", "label", "help", the keys of their "parameters", and those of them
    that a tree has itself where it begins with such a source."""
    return list(_kinds.values())


class Step:
    """One step. It is the same one wherever it moves to; what was removed raises Error."""

    def __init__(self, work: Any, tree: int, number: int):
        self._work, self._tree, self._id = work, tree, number

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Step) and (self._work, self._tree, self._id) == (other._work, other._tree, other._id)

    def __hash__(self) -> int:
        return hash((id(self._work), self._tree, self._id))

    def __repr__(self) -> str:
        return f"<ramure.Step {self.name}{'' if self.enabled else ', off'}>"

    def _facts(self) -> tuple:
        for facts in self._work.steps(self._tree):
            if facts[0] == self._id:
                return facts
        raise Error("the step is no longer there", "unknown")

    @property
    def kind(self) -> str:
        """ "growth", "sag", "cut": see step_kinds()."""
        return self._facts()[1]

    @property
    def name(self) -> str:
        return self._facts()[2]

    @name.setter
    def name(self, name: str) -> None:
        self._work.rename_step(self._tree, self._id, name)

    @property
    def enabled(self) -> bool:
        return self._facts()[3]

    @enabled.setter
    def enabled(self, on: bool) -> None:
        self._work.enable_step(self._tree, self._id, bool(on))

    @property
    def state(self) -> str:
        """What became of it: "placed", "matched", "unplaced", "idle", "off", "frozen" or "waits". Grows the tree."""
        return self._work.step_state(self._tree, self._id, None)[0]

    @property
    def why(self) -> str:
        """Why it cannot act, or "". Grows the tree."""
        return self._work.step_state(self._tree, self._id, None)[1]

    @property
    def data(self) -> dict:
        """A copy of the step as project files have it: what hands did has its values here."""
        if self._id == 0:
            return {"op": self.kind, "values": {key: self[key] for key in self.keys()}}
        return json.loads(self._work.step_data(self._tree, self._id))[0]

    def keys(self) -> List[str]:
        """Of its parameters."""
        which = "parameters" if self._id else "tree_parameters"  # the first source stands on no other
        return list(_kinds[self.kind][which]) if self.kind in _kinds else []

    def __getitem__(self, key: str) -> Any:
        return self._work.step_value(self._tree, self._id, key)

    def __setitem__(self, key: str, value: Any) -> None:
        self._work.set_step_value(self._tree, self._id, key, value)

    def remove(self) -> None:
        self._work.remove_step(self._tree, self._id)

    def move(self, place: int) -> None:
        """To another place: 1 is right behind the source."""
        if place < 1:
            raise Error("the source that a recipe begins with stays where it is")
        self._work.move_step(self._tree, self._id, place)


class Steps:
    """The recipe as a sequence: steps[0] is the source; steps["sag"] is found by its name."""

    def __init__(self, work: Any, tree: int):
        self._work, self._tree = work, tree

    def _list(self) -> List[Step]:
        return [Step(self._work, self._tree, facts[0]) for facts in self._work.steps(self._tree)]

    def __len__(self) -> int:
        return len(self._work.steps(self._tree))

    def __iter__(self) -> Iterator[Step]:
        return iter(self._list())

    def __getitem__(self, which: Union[int, str]) -> Step:
        if isinstance(which, int):
            return self._list()[which]
        found = [facts[0] for facts in self._work.steps(self._tree) if facts[2] == which]
        if len(found) != 1:
            raise KeyError(which)
        return Step(self._work, self._tree, found[0])

    def __repr__(self) -> str:
        return f"<ramure.Steps {', '.join(step.name for step in self)}>"

    def add(self, kind: str, values: Optional[Mapping[str, Any]] = None, *, place: int = 0, name: str = "") -> Step:
        """Adds a modifier or a further source, behind all others or at a place from 1 on. An error adds nothing."""
        if place < 0:
            raise Error("places begin with 1; 0 is behind all others")
        number = self._work.add_step(self._tree, kind, place, name, dict(values or {}))
        return Step(self._work, self._tree, number)
