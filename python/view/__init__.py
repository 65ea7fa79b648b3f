"""Pictures of a run: what `pinball view` runs."""
