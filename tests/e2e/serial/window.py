#!/usr/bin/env python3
"""Does to the browser's window on $DISPLAY what its user does: window.py close, or window.py keys Alt_L+f x

`close` is what the X of a title bar sends: WM_DELETE_WINDOW, by the Inter-Client Communication Conventions Manual, 4.2.8.1."""

import sys
import time

from Xlib import X, XK, Xatom, display
from Xlib.ext import xtest
from Xlib.protocol import event

screen = display.Display()


def is_browser(window):
    seen = window.get_attributes().map_state == X.IsViewable
    return seen and "chrom" in str(window.get_wm_class()).lower() and window.get_full_property(screen.intern_atom("WM_PROTOCOLS"), Xatom.ATOM)


windows = [window for window in screen.screen().root.query_tree().children if is_browser(window)]
if not windows:
    sys.exit("no window of a browser")
window = windows[-1]
what, *keys = sys.argv[1:]
if what == "close":
    data = (32, [screen.intern_atom("WM_DELETE_WINDOW"), X.CurrentTime, 0, 0, 0])
    window.send_event(event.ClientMessage(window=window, client_type=screen.intern_atom("WM_PROTOCOLS"), data=data))
else:
    # Nobody manages windows here, so none has the keyboard by itself.
    window.set_input_focus(X.RevertToParent, X.CurrentTime)
    for together in keys:
        codes = [screen.keysym_to_keycode(XK.string_to_keysym(key)) for key in together.split("+")]
        for code in codes:
            xtest.fake_input(screen, X.KeyPress, code)
        for code in reversed(codes):
            xtest.fake_input(screen, X.KeyRelease, code)
        screen.sync()
        # A menu has to open before its entry can be chosen.
        if together != keys[-1]:
            time.sleep(0.5)
screen.sync()
