"""Ends a command with one line, in place of a traceback, where Python is too old for it.

A command says what it needs before it imports anything else of lib/, so this file is read by every Python 3.
"""

import os
import sys


def python(major, minor):
    """3.9 for what users call, and 3.11 for what works on the project: needs_test.py holds the files to that."""
    if sys.version_info >= (major, minor):
        return
    # A command of the shell starts command.py in a folder of its name.
    program, name = os.path.split(sys.argv[0] or "-c")
    another = "Another one is taken like this: python3.12 tools/%s" % name
    if name == "command.py":
        name, another = os.path.basename(program), "The first python3 of the PATH is taken."
    sys.stderr.write("tools/%s needs Python %d.%d or later, and this is %d.%d (%s). %s\n"
                     % (name, major, minor, *sys.version_info[:2], sys.executable, another))
    sys.exit(4)
