#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace pinball {

/// Throws InputError for a path at which there is no file: nothing, a folder, a pipe or a device. Such may never end,
/// and what is taken from a pipe is not there a second time.
void require_file(const std::string& path);

/// All bytes of a file. Throws InputError as require_file, for one that cannot be read and for one that is larger than
/// the memory of this machine.
std::string bytes_of_file(const std::string& path);

/// Of bytes as they were read: whether a file has changed since.
std::uint64_t hash_of_bytes(std::string_view bytes);
/// The same of a file that another library reads. Throws InputError for one that cannot be read.
std::uint64_t hash_of_file(const std::string& path);

/// Throws InputError for so many bytes of a file, or of what it names, where this machine has not so many.
void require_memory(const std::string& path, std::uintmax_t bytes);

}  // namespace pinball
