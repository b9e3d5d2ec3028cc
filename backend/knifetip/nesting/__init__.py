"""Nesting: place blanks of true shape on as little board as possible.

drawings → Part → nest → Arrangement → Layout of each sheet
                    ↑ engine: sparrow, in a process of its own
"""
