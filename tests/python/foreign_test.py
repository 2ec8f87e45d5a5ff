"""Reading in a child process: what it hands on, and what becomes of crashes and endless loops."""
import os
import signal
import tempfile
import unittest
from unittest import mock

import numpy

from harmos import foreign
from harmos.foreign import read_foreign


class ForeignTest(unittest.TestCase):
    def setUp(self) -> None:
        file = tempfile.NamedTemporaryFile()
        self.addCleanup(file.close)
        self.path = file.name

    def test_hands_on_what_was_read(self) -> None:
        content = numpy.arange(1e6)
        numpy.testing.assert_array_equal(read_foreign(self.path, lambda: content), content)

    def test_an_end_without_an_answer_is_damage(self) -> None:
        def end() -> None:
            os._exit(0)

        with self.assertRaisesRegex(ValueError, "reading it ends the process"):
            read_foreign(self.path, end)

    def test_memory_has_an_end(self) -> None:
        with self.assertRaisesRegex(ValueError, "MemoryError"):
            read_foreign(self.path, lambda: numpy.ones(10**12))

    def test_errors_name_the_file(self) -> None:
        def refuse(error: Exception) -> None:
            raise error

        with self.assertRaisesRegex(ValueError, f"^{self.path} is too new$"):
            read_foreign(self.path, lambda: refuse(ValueError(f"{self.path} is too new")))
        with self.assertRaisesRegex(ValueError, f"^{self.path} is damaged: KeyError: 'id'$"):
            read_foreign(self.path, lambda: refuse(KeyError("id")))
        with self.assertRaises(FileNotFoundError):
            read_foreign(self.path + "none", lambda: None)

    def test_a_crash_is_the_fault_of_the_file(self) -> None:
        with self.assertRaisesRegex(ValueError, f"{self.path} is damaged: reading it fails, Segmentation fault"):
            read_foreign(self.path, lambda: os.kill(os.getpid(), signal.SIGSEGV))

    def test_an_endless_loop_ends(self) -> None:
        def loop() -> None:
            while True:
                pass

        with mock.patch.object(foreign, "SECONDS", 1):
            with self.assertRaisesRegex(ValueError, f"{self.path} is damaged: reading it does not end"):
                read_foreign(self.path, loop)

    def test_an_interruption_at_the_fork_is_not_lost(self) -> None:
        class Interrupted(Exception):
            pass

        def interrupt(*_: object) -> None:
            raise Interrupted

        due = [True]

        def send() -> None:
            if due and due.pop():
                os.kill(os.getpid(), signal.SIGTERM)

        os.register_at_fork(after_in_parent=send)  # as logging does for its locks
        self.addCleanup(signal.signal, signal.SIGTERM, signal.signal(signal.SIGTERM, interrupt))
        with self.assertRaises(Interrupted):
            read_foreign(self.path, lambda: None)
        with self.assertRaises(ChildProcessError, msg="the child was not waited for"):
            os.waitpid(-1, os.WNOHANG)


if __name__ == "__main__":
    unittest.main()
