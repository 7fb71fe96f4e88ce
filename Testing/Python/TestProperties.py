#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""All filters keep VTK's manners: setting a property changes the time, describing a filter names it.

The classes, their properties and lists are found by looking at the classes.
"""

import inspect
import unittest

import medialaxis
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

FILTERS = sorted((cls for cls in vars(medialaxis).values()
                  if inspect.isclass(cls) and issubclass(cls, vtkAlgorithm)),
                 key=lambda cls: cls.__name__)


def own_methods(cls):
    return [name for name, value in vars(cls).items() if inspect.isroutine(value)]


def properties(cls):
    """The names X of pairs SetX and GetX of one number or truth value that the class adds."""
    names = own_methods(cls)
    for name in names:
        if name.startswith("Set") and "Get" + name[3:] in names:
            if isinstance(getattr(cls(), "Get" + name[3:])(), (bool, int, float)):
                yield name[3:]


def lists(cls):
    """The names X of lists: pairs AddX and ClearXs, or AddXToDo and ClearXsToDo."""
    names = own_methods(cls)
    for name in names:
        if name.startswith("Clear"):
            yield name[5:]


def adders(cls, plural):
    """The methods that add to a list: AddPartToRemove for PartsToRemove."""
    return [name for name in own_methods(cls) if name.startswith("Add") and
            (name[3:] + "s" == plural or
             any(plural == name[3:].replace(noun, noun + "s", 1) for noun in ("Part", "Cell")))]


def other_values(value):
    if isinstance(value, bool):
        return [not value]
    return [value + step for step in (1, -1, 0.25, -0.25)]


class Properties(unittest.TestCase):
    def change(self, filter, name):
        """Sets a property to another value; returns that it was taken."""
        before = getattr(filter, "Get" + name)()
        for value in other_values(before):
            try:
                getattr(filter, "Set" + name)(value)
            except TypeError:
                continue  # a whole number is wanted
            if getattr(filter, "Get" + name)() != before:
                return True
        return False

    def test_there_are_some(self):
        self.assertGreaterEqual(len(FILTERS), 8)
        self.assertGreater(sum(len(list(properties(cls))) for cls in FILTERS), 15)
        self.assertGreaterEqual(sum(len(list(lists(cls))) for cls in FILTERS), 5)

    def test_change_the_time_where_they_change(self):
        for cls in FILTERS:
            for name in properties(cls):
                with self.subTest(cls.__name__ + "." + name):
                    filter = cls()
                    before = filter.GetMTime()
                    self.assertTrue(self.change(filter, name), "no other value is taken")
                    changed = filter.GetMTime()
                    self.assertGreater(changed, before)
                    getattr(filter, "Set" + name)(getattr(filter, "Get" + name)())
                    self.assertEqual(filter.GetMTime(), changed, "the same value again")

    def test_of_lists_change_the_time(self):
        for cls in FILTERS:
            for plural in lists(cls):
                methods = adders(cls, plural)
                self.assertTrue(methods, plural)
                for method in methods:
                    with self.subTest(cls.__name__ + "." + method):
                        filter = cls()
                        before = filter.GetMTime()
                        getattr(filter, method)(*((3, 7) if method == "AddIteration" else (3,)))
                        added = filter.GetMTime()
                        self.assertGreater(added, before)
                        getattr(filter, "Clear" + plural)()
                        self.assertGreater(filter.GetMTime(), added)

    def test_are_named_where_a_filter_describes_itself(self):
        for cls in FILTERS:
            text = str(cls())
            for name in properties(cls):
                with self.subTest(cls.__name__ + "." + name):
                    self.assertIn(name + ":", text)
            for plural in lists(cls):
                with self.subTest(cls.__name__ + "." + plural):
                    shown = "Schedule" if plural == "Iterations" else plural
                    self.assertIn(shown + ":", text)

    def test_show_their_values(self):
        for cls in FILTERS:
            for name in properties(cls):
                with self.subTest(cls.__name__ + "." + name):
                    filter = cls()
                    before = str(filter).count("\n")
                    lines = {line for line in str(filter).split("\n") if name + ":" in line}
                    self.assertTrue(self.change(filter, name))
                    after = {line for line in str(filter).split("\n") if name + ":" in line}
                    self.assertNotEqual(lines, after)
                    self.assertEqual(str(filter).count("\n"), before)


if __name__ == "__main__":
    unittest.main()
