// The options that FileMicrophone and FileSpeaker have in common: which file,
// how fast, and how much silence.
#pragma once

#include <filesystem>
#include <vector>

#include "adapters/audio/pace.hpp"
#include "runtime/plugin/option_reader.hpp"

namespace parlour::adapters {

struct FileOptions {
  std::filesystem::path file;
  Pace pace;
  Milliseconds silence{0}; // up to an hour
};

// Reads the options `file`, `pace` and `silence`. `file` of the command line
// takes the place of the option, which is a file of `folder`; empty: there is
// none. The path is empty if the option is.
FileOptions read_file_options(OptionReader& read,
                              const std::filesystem::path& file,
                              const std::filesystem::path& folder);

} // namespace parlour::adapters
