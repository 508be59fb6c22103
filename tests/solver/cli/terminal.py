"""Runs a program on a terminal of a given width."""

import fcntl
import os
import pty
import struct
import termios


def on_terminal(command, folder, columns):
    """Exit code, and what the terminal received, as text."""
    read_end, write_end = os.pipe()
    process, terminal = pty.fork()
    if process == 0:
        os.read(read_end, 1)  # until the terminal has its width
        os.chdir(folder)
        os.execv(command[0], command)
    fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    os.write(write_end, b"x")
    received = b""
    while True:
        try:
            part = os.read(terminal, 4096)
        except OSError:  # how Linux says that the other end is closed
            part = b""
        if not part:
            break
        received += part
    for end in (read_end, write_end, terminal):
        os.close(end)
    return os.waitstatus_to_exitcode(os.waitpid(process, 0)[1]), received.decode()
