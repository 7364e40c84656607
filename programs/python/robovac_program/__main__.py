"""python3 -m robovac_program FILE"""

import sys

from .native import serve


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: python3 -m robovac_program FILE   (a program for `robovac run`)")
    out = sys.stdout

    def write(text):
        out.write(text)
        out.flush()

    sys.exit(serve(sys.argv[1], sys.stdin.readline, write))


main()
