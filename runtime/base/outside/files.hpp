// What scripts may do with the files of their data folder (language rules 11.5
// to 11.8), as data and one function. adapters/files implements it; `script`
// and `actors` only call it.
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
  // Below the data folder; '/' separates the parts. For `list` a pattern.
  std::string name;
  std::string text;                               // to write or append
  std::size_t max_bytes = defaults::result_bytes; // of the whole file
};

// Carries out the request and blocks until it is done. Returns the text (read),
// a sorted list of names (list) or unknown. All errors are of kind File. Safe
// to call from several threads.
using FileAccess = std::function<Expected<Value>(const FileRequest&)>;

} // namespace parlour
