"""SIGINT and SIGTERM: the right status, no output, nothing left over, the older file untouched."""

import signal
import subprocess
import time

from cli import PROGRAM, TIMEOUT_S, GlareTest

LONG = ("--size", "2048", "--threads", "1")
SOON_S = 15  # From the signal to the end, on a slow and busy machine.


class Interruption(GlareTest):
    def interrupted(self, number, after_s):
        self.write("out.exr", "old")
        before = self.files()
        with subprocess.Popen([PROGRAM, "template", "-o", "out.exr", "--preview", "p.png", *LONG],
                              cwd=self.folder, env=self.environment, stderr=subprocess.PIPE,
                              text=True) as process:
            time.sleep(after_s)
            self.assertIsNone(process.poll(), "ended before the signal")
            process.send_signal(number)
            start = time.monotonic()
            _, err = process.communicate(timeout=TIMEOUT_S)
        self.assertLess(time.monotonic() - start, SOON_S)
        self.assertLessEqual(len(err.splitlines()), 1, err)
        self.assertEqual(self.files(), before)
        return process.returncode

    def test_interrupt(self):
        self.assertEqual(self.interrupted(signal.SIGINT, 1), 130)

    def test_terminate(self):
        self.assertEqual(self.interrupted(signal.SIGTERM, 2), 143)
