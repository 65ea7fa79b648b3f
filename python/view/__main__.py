"""python3 PATH/view ARGUMENTS: what `pinball view` starts. The folder is a package, found beside itself."""

import os
import sys

sys.path[0] = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

from view.command import main  # noqa: E402

sys.exit(main(sys.argv[1:]))
