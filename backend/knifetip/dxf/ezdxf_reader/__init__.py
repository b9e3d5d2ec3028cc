"""Reads any DXF with ezdxf, which repairs much of what is damaged.

bytes -> prescan -> ezdxf document -> expand (INSERTs) -> place (columns) -> Drawing
"""
