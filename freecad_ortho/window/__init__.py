"""What commands and panels share: what is selected, lines of a macro, messages, dialogs."""
