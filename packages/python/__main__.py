"""What the program starts, as python3 FOLDER VERB ...: this folder comes first on the module path, no other harmos wins."""
import importlib
import signal
import sys

MODULES = {"report": "harmos.report.__main__", "import": "harmos.exchange.__main__",
           "convert": "harmos.exchange.__main__", "picture": "harmos.render", "show": "harmos.show", "export": "harmos.vtu",
           "trade": "harmos.trade.__main__"}
"""Where the function main() of each verb is; it takes the words that it is given."""

INTERRUPTIONS = (signal.SIGTERM, signal.SIGINT)
"""Both come at Ctrl-C: one of the terminal, one of the program that has started this process."""


def end(*_: object) -> None:
    """Ends the process, once: what was being written is removed on the way out."""
    for interruption in INTERRUPTIONS:
        signal.signal(interruption, lambda *_: None)  # SIG_IGN would be complained about when one is on its way
    sys.exit(130)


for each in INTERRUPTIONS:
    signal.signal(each, end)
verb = sys.argv[1]
is_exchange = MODULES[verb].startswith("harmos.exchange")  # its verbs are one program
sys.exit(importlib.import_module(MODULES[verb]).main(sys.argv[1:] if is_exchange else sys.argv[2:]))
