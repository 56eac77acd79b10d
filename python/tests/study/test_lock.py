"""Locks of studies and of the runs under them."""

import fcntl
import threading
import time

import pytest

from nilas.study.carry_out.lock import only_one, wait_until_left
from nilas.study.describe.faults import StudyError


def test_a_second_study_in_a_folder_is_refused(tmp_path):
    with only_one(tmp_path, "study.lock"):
        with pytest.raises(StudyError, match="Another process") as told:
            with only_one(tmp_path, "study.lock"):
                pass
    assert told.value.code == 4
    with only_one(tmp_path, "study.lock"):
        pass


def test_a_run_that_another_process_still_writes_is_waited_for(tmp_path):
    stream = open(tmp_path / "nilas.log", "w")
    fcntl.flock(stream, fcntl.LOCK_EX)
    threading.Timer(0.2, stream.close).start()
    begun = time.monotonic()
    wait_until_left(tmp_path)
    assert stream.closed and time.monotonic() - begun > 0.15


def test_a_run_that_is_not_left_in_time_is_named(tmp_path):
    with open(tmp_path / "nilas.log", "w") as stream:
        fcntl.flock(stream, fcntl.LOCK_EX)
        with pytest.raises(StudyError, match=str(tmp_path)) as told:
            wait_until_left(tmp_path, patience_s=0.05)
    assert told.value.code == 4


def test_a_folder_without_a_run_is_not_waited_for(tmp_path):
    wait_until_left(tmp_path / "none", patience_s=0.0)
