"""linuxcnc: the driver of LinuxCNC, which runs programs through the remote shell linuxcncrsh."""
