def stop_program():
    """Ends the program."""
    raise SystemExit
