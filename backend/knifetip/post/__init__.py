"""Post-processors: write programs from toolpaths, one emitter for each controller language.

The languages are HPGL and the dialects of RS274/NGC (G-code) that LinuxCNC and grblHAL read.
"""
