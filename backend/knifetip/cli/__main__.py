"""Run the command line with ``python -m knifetip.cli``."""

from knifetip.cli.main import main

main()
