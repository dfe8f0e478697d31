"""SIGINT and SIGTERM: the right status, no output, nothing left over, the older file untouched."""

import signal
import subprocess
import time

from cli import PROGRAM, TIMEOUT_S, GlareTest

# Seconds of work on a fast machine: the signal, sent a moment after the start, comes long before
# the end.
LONG = ("--size", "4096", "--fov-deg", "4", "--threads", "1")
SOON_S = 15  # From the signal to the end, on a slow and busy machine.


def watches_for(number, pid):
    """Whether the process has a handler of its own for the signal (Linux's /proc)."""
    with open(f"/proc/{pid}/status", encoding="ascii") as status:
        caught = next(line.split()[1] for line in status if line.startswith("SigCgt:"))
    return int(caught, 16) >> (number - 1) & 1


class Interruption(GlareTest):
    def wait_for_handler(self, number, process):
        end = time.monotonic() + SOON_S
        while not watches_for(number, process.pid):
            self.assertLess(time.monotonic(), end, "no handler was set")
            time.sleep(0.01)

    def interrupted(self, number, after_s):
        self.write("out.exr", "old")
        before = self.files()
        with subprocess.Popen([PROGRAM, "template", "-o", "out.exr", "--preview", "p.png", *LONG],
                              cwd=self.folder, env=self.environment, stderr=subprocess.PIPE,
                              text=True) as process:
            self.wait_for_handler(number, process)
            time.sleep(after_s)
            self.assertIsNone(process.poll(), "ended before the signal")
            process.send_signal(number)
            start = time.monotonic()
            _, err = process.communicate(timeout=TIMEOUT_S)
        self.assertLess(time.monotonic() - start, SOON_S)
        self.assertLessEqual(len(err.splitlines()), 1, err)
        self.assertTrue(self.files() == before, "the files are others")
        return process.returncode

    def test_interrupt(self):
        self.assertEqual(self.interrupted(signal.SIGINT, 0), 130)

    def test_terminate(self):
        self.assertEqual(self.interrupted(signal.SIGTERM, 0.3), 143)
