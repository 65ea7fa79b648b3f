"""Names of the standard library in our headers, each of which the header or one of ours that it includes gets by its own
include. The compiler does not see it where headers are compiled alone: common standard headers are read once for all.

    standard_names.py [TREE]      prints every name that is not included; exit status 1 if there is one
"""

import functools
import pathlib
import re
import sys

import checked_tree

# Each name is in the first of the headers named, and in the others, too.
NAMES = {
    "algorithm": "all_of clamp copy_backward copy_n fill find lower_bound max min minmax_element ranges sort swap_ranges unique upper_bound",
    "array": "array",
    "atomic": "atomic atomic_flag atomic_ref memory_order_acquire memory_order_relaxed memory_order_release",
    "bit": "bit_cast bit_ceil countr_zero popcount rotl",
    "charconv": "from_chars to_chars",
    "chrono": "chrono",
    "cmath": "cbrt floor hypot isfinite sqrt trunc",
    "cmath cstdlib": "abs",
    "cstddef": "byte ptrdiff_t",
    "cstdio": "FILE",
    "cstddef cstdio cstdlib cstring": "size_t",
    "cstdint": "int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t uintmax_t uintptr_t",
    "cstdlib": "aligned_alloc free",
    "cstring": "memcpy memset strlen",
    "deque": "deque",
    "exception": "current_exception exception exception_ptr rethrow_exception",
    "experimental/simd": "experimental",
    "filesystem": "filesystem",
    "functional": "function",
    "initializer_list": "initializer_list",
    "limits": "numeric_limits",
    "map": "map multimap",
    "memory": "make_shared make_unique shared_ptr unique_ptr",
    "mutex": "lock_guard mutex recursive_mutex unique_lock",
    "new": "bad_alloc",
    "optional": "nullopt optional",
    "set": "set",
    "span": "as_bytes as_writable_bytes span",
    "sstream": "ostringstream",
    "stdexcept": "invalid_argument length_error logic_error runtime_error",
    "string": "string to_string",
    "string_view string": "string_view",
    "system_error charconv": "errc",
    "type_traits": "conditional_t enable_if_t false_type is_arithmetic_v is_const_v is_floating_point_v is_integral_v is_invocable_v"
                   " is_pointer_v is_same_v is_signed_v is_trivially_copyable_v is_unsigned_v remove_const_t true_type type_identity_t",
    "unordered_map": "unordered_map",
    "tuple": "apply tie",
    "utility": "as_const exchange index_sequence make_index_sequence move",
    "utility algorithm": "swap",
    "utility map": "pair",
    "utility array tuple": "tuple_size",
    "variant": "get_if holds_alternative variant visit",
    "vector": "vector",
    "vector string deque map set unordered_map": "erase_if",
    "vector string deque map set unordered_map array span iterator": "ssize",
}
HEADERS_OF = {name: headers.split() for headers, names in NAMES.items() for name in names.split()}

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.M)
COMMENT_OR_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"', re.S)
NAME = re.compile(r"\bstd::(\w+)")


def problems(tree):
    tree = pathlib.Path(tree).resolve()

    @functools.cache
    def includes(file):
        """(headers from outside, headers of the tree) that a header includes itself."""
        outside, ours = set(), set()
        for bracket, name in INCLUDE.findall(file.read_text()):
            other = file.parent / name if bracket == '"' else tree / name
            (ours if other.is_file() else outside).add(other.resolve() if other.is_file() else name)
        return outside, ours

    def reached(file):
        """Headers from outside that a header gets by itself and by others of the tree."""
        found, seen, left = set(), {file}, [file]
        while left:
            outside, ours = includes(left.pop())
            found |= outside
            left += ours - seen
            seen |= ours
        return found

    wrong = []
    for file in sorted(file for room in ("kernels", "solver") for file in (tree / room).rglob("*.hpp")):
        names = set(NAME.findall(COMMENT_OR_TEXT.sub("", file.read_text())))
        included = reached(file)
        for name in sorted(names):
            if name not in HEADERS_OF:
                wrong.append(f"{file.relative_to(tree)}: std::{name} is not among the NAMES of standard_names.py: which header has it?")
            elif not included.intersection(HEADERS_OF[name]):
                wrong.append(f"{file.relative_to(tree)}: std::{name} without <{HEADERS_OF[name][0]}>")
    return wrong


if __name__ == "__main__":
    sys.exit(checked_tree.print_problems(problems(checked_tree.chosen())))
