"""python -m knifetip.cli is knifetip."""

from knifetip.cli.main import main

main()
