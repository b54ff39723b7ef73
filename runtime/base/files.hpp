// What scripts may do with the files of their data folder (language rules 11.5
// to 11.8), as data, and the door by which it is done. An adapter knows how
// (adapters/files); `script` and `actors` only ask.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "runtime/base/defaults.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour {

enum class FileAction : std::uint8_t { read, write, append, remove, list };

struct FileRequest {
  FileAction action = FileAction::read;
  std::string name; // below the data folder, parts separated by '/'; of list: a
                    // pattern
  std::string text; // to write or append
  std::size_t most_bytes = defaults::result_bytes; // of the whole file
};

// Does it at once and blocks meanwhile. Gives the text (read), a sorted list of
// names (list), or unknown. All errors are of kind File. Safe to call from
// several threads.
using FileAccess = std::function<Expected<Value>(const FileRequest&)>;

} // namespace parlour
