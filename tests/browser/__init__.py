"""Tests of the page in Chromium; a package, so that a fixture can last for all of its modules."""
