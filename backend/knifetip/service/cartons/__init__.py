"""Carton styles: drawings that are made from a code, dimensions and a board."""
