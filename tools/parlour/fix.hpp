// Fix: what `check` can safely correct, written into the files (script rule
// 14.3). A file changes whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "script/findings.hpp"

namespace parlour::tools {

struct FixedFile {
  std::string file;
  std::vector<script::Finding> fixed; // in the order of the file
};

// The text with the corrections of `findings`, which are of that file, and
// which of them were made: of two that overlap, the first.
std::string apply_fixes(std::string text,
                        const std::vector<script::Finding>& findings,
                        std::vector<script::Finding>& fixed);

// Corrects the files below `folder`. The error says which file could not be
// written; it is as it was, and so are those after it.
Expected<std::vector<FixedFile>>
fix_files(const std::vector<script::Finding>& findings,
          const std::filesystem::path& folder);

// Puts the text in the file's place, its permissions kept; a file that a link
// stands for is replaced where it is.
Expected<void> replace_file(const std::filesystem::path& file,
                            const std::string& text);

} // namespace parlour::tools
