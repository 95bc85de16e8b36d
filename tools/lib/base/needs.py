"""Ends a command with one line, in place of a traceback, where Python is too old for it.

A command states what it needs before it imports anything else of lib/, so this file is read by every Python 3.
"""

import os
import sys

from base import ending

VERSION = (3, 11)


def python(*words):
    """The words are the command line's, where a command of the shell has several."""
    if sys.version_info >= VERSION:
        ending.with_children()
        return
    program, name = os.path.split(sys.argv[0] or "-c")
    if name == "command.py":  # started by a command of the shell, in a folder of its name
        name = " ".join(words) or os.path.basename(program)
        another = "The first python3 of the PATH is taken."
    else:
        another = "Another one is taken like this: python3.12 tools/%s" % name
    sys.stderr.write("tools/%s needs Python %d.%d or later, and this is %d.%d (%s). %s\n"
                     % (name, *VERSION, *sys.version_info[:2], sys.executable, another))
    sys.exit(4)
