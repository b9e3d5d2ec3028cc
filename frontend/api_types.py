"""api_types: writes the description of the REST API, from which the page's types are made.

knifetip.server -> the file that is named on the command line          api_types.py FILE
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from knifetip.server.app import create_app

if __name__ == "__main__":
    Path(sys.argv[1]).write_text(json.dumps(create_app().openapi()), encoding="utf-8")
