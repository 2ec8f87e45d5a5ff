"""What `harmos report` starts: python3 FOLDER puts this folder first on the module path, so that no other harmos wins."""
import sys

from harmos.report.__main__ import main

sys.exit(main())
