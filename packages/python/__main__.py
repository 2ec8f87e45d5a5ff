"""What `harmos report` starts, as python3 FOLDER: this folder comes first on the module path, no other harmos wins."""
import sys

from harmos.report.__main__ import main

sys.exit(main())
