"""Run a program and print its exit status (negative: the signal that ended it),
the seconds that it took, and the largest memory that it held, in KiB; of a
program that starts others, that of the largest of them all.

    launch.py SECONDS GIB PROGRAM [ARGUMENTS]

It gets SIGALRM after SECONDS, and no more than GIB of address space. Linux
counts the memory of the process that starts a program as the program's own,
which therefore has to be small, as this one is.
"""
import os
import resource
import signal
import sys
import time

start = time.perf_counter()
child = os.fork()
if child == 0:
    signal.alarm(int(sys.argv[1]))
    space = int(float(sys.argv[2]) * 2**30)
    resource.setrlimit(resource.RLIMIT_AS, (space, space))
    os.dup2(2, 1)
    os.execvp(sys.argv[3], sys.argv[3:])
_, status, usage = os.wait4(child, 0)
print(os.waitstatus_to_exitcode(status), time.perf_counter() - start,
      usage.ru_maxrss)
