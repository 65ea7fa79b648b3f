"""Parts of bench/faults."""
