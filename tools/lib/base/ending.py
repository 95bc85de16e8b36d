"""Ends with a command what it has started, such as a build, which would run on. Every Python 3 reads this file."""

import os
import signal


def _parents():
    """Each process of this machine, and its parent."""
    if os.path.isdir("/proc/self"):
        for name in filter(str.isdigit, os.listdir("/proc")):
            try:
                with open("/proc/%s/stat" % name, "rb") as file:
                    yield int(name), int(file.read().rpartition(b")")[2].split()[1])
            except OSError:  # it has ended
                pass
    else:
        for line in os.popen("ps -A -o pid=,ppid="):
            yield tuple(map(int, line.split()))


def _end(number, _):
    signal.signal(number, signal.SIG_DFL)
    parents, left = list(_parents()), [os.getpid()]
    while left:
        of = left.pop()
        for process in [process for process, parent in parents if parent == of]:
            left.append(process)
            try:
                os.kill(process, signal.SIGTERM)
            except OSError:
                pass
    os.kill(os.getpid(), number)


def with_children():
    """From now on SIGTERM and SIGHUP, unless they are ignored, end this process with all that it has started."""
    for number in (getattr(signal, name, None) for name in ("SIGTERM", "SIGHUP")):
        if os.name == "posix" and signal.getsignal(number) == signal.SIG_DFL:
            signal.signal(number, _end)
