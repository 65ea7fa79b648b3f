"""Whether the kernels of the mock device and those of the host share a function that is called. What a compiler makes of
it may be another thing in another file, so that a host would have other last bits in a program with the mock than in one
without it.

    mock_symbols_test.py OBJECT...      of the solver, both kinds among them
"""

import subprocess
import sys
import unittest

OBJECTS = [path for path in sys.argv[1:] if path.endswith(".o")]


def shared_functions(objects):
    """Names of what any of the objects defines for whoever is linked first."""
    lines = subprocess.run(["nm", "-C", *objects], check=True, capture_output=True, text=True).stdout.splitlines()
    weak = (line.split(maxsplit=2) for line in lines if " W " in line)
    return {name for _, _, name in weak if "pinball::" in name}


class MockSymbols(unittest.TestCase):
    def test_kernels_share_no_function_with_those_of_the_host(self):
        mock = [path for path in OBJECTS if "/mock/mock_elements" in path]
        host = [path for path in OBJECTS if "/elements/tile_kernels" in path]
        self.assertEqual((len(mock), len(host)), (5, 7))
        self.assertTrue(any("update_tile" in name for name in shared_functions(host)), "nm names nothing")
        self.assertEqual(sorted(shared_functions(mock) & shared_functions(host)), [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
