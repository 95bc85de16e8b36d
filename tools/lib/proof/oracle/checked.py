"""Tests of a class whose checks are also run with faults, which they have to notice."""

from __future__ import annotations


class Checked:
    """Stands before unittest.TestCase among the bases of a class that has a method check_NAME for each of CHECKS."""
    CHECKS: tuple[str, ...]
    NOTICED: type[Exception] | tuple[type[Exception], ...] = AssertionError  # what a check raises at a fault

    def test_every_check_passes(self) -> None:
        for check in self.CHECKS:
            with self.subTest(check):
                getattr(self, f"check_{check}")()

    def assert_noticed(self, *noticing: str) -> None:
        for check in noticing:
            with self.assertRaises(self.NOTICED, msg=check):
                getattr(self, f"check_{check}")()
