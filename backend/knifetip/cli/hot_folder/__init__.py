"""hot_folder: order jobs for drawings that are put into a folder.

arrivals    which files of a folder are complete
beside      drawings that orders in XJDF name
orders      processing of one file: moved, ordered, and put beside its results
client      requests to the server
reservation one process for each folder
"""
