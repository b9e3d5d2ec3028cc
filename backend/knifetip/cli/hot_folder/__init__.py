"""hot_folder: order jobs for drawings that are put into a folder.

arrivals    which files of a folder are complete
orders      one file on its way: taken, ordered, and put beside its results
client      requests to the server
"""
