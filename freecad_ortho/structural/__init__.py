"""Whether a grid shell stands: a frame from its net, loads, checks, and what is written of it."""
