"""Long work lets Python go on, tells how far it is, and can be stopped."""
import os
import signal
import threading
import time

import glare
import pytest
from pupils import disc

LONG = {"size": 1024, "fov_deg": 8, "threads": 1}  # Some seconds on one core.


def test_other_threads_go_on():
    steps, done = [], threading.Event()

    def count():
        while not done.wait(0.01):
            steps.append(time.monotonic())

    counter = threading.Thread(target=count)
    counter.start()
    begin = time.monotonic()
    glare.template(size=512, threads=1)
    took = time.monotonic() - begin
    done.set()
    counter.join()
    # A step takes 0.01 s and a little; with the GIL held there would be hardly any.
    assert len([s for s in steps if begin <= s <= begin + took]) > took / 0.01 * 0.1


def test_progress_is_told_in_this_thread():
    shares, threads = [], set()

    def note(share):
        shares.append(share)
        threads.add(threading.get_ident())

    glare.template(size=128, threads=1, progress=note)
    assert shares == sorted(shares) and shares[-1] == 1 and 0 <= shares[0]
    assert threads == {threading.get_ident()}


def test_progress_stops():
    with pytest.raises(glare.Cancelled):
        glare.template(**LONG, progress=lambda share: False)


def test_what_progress_raises_is_passed_on():
    def fail(share):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        glare.template(**LONG, progress=fail)


def test_keyboard_interrupt():
    timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        for _ in range(100):
            glare.template(**LONG)
    timer.join()
    assert time.monotonic() - begin < 30  # A hundred templates would take minutes.


def test_several_at_once():
    made = [None] * 4

    def make(i):
        made[i] = glare.template(pupil=disc(64, 0.9), width_mm=0.5, size=64, fov_deg=2)

    workers = [threading.Thread(target=make, args=(i,)) for i in range(len(made))]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert all((one.rgb == made[0].rgb).all() for one in made)
