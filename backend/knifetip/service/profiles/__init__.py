"""Classification profiles of the library and of customers."""
