// Fix: what `check` can safely correct. A correction is kept only where what is
// found afterwards is no worse; a file changes whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "script/compiler/application_loader.hpp"
#include "script/source/findings.hpp"

namespace parlour::tools {

// What there is to say where these texts stand for their files.
using Check =
    std::function<std::vector<script::Finding>(const script::SourceTexts&)>;

struct Corrected {
  script::SourceTexts texts;             // of the files that change
  std::vector<script::Finding> made;     // as they were found
  std::vector<script::Finding> findings; // that remain
};

// The text with the corrections of `findings`, which are of that file, and
// which of them were made: of two that overlap, the first.
std::string apply_fixes(std::string text,
                        const std::vector<script::Finding>& findings,
                        std::vector<script::Finding>& fixed);

// Whether there are more errors, more findings where there were no errors
// (which hide warnings), or a file that is not well-formed any more.
bool is_worse(const std::vector<script::Finding>& findings,
              const std::vector<script::Finding>& before);

// Corrects the files below `folder` as far as that does no harm. Writes
// nothing.
Corrected correct(std::vector<script::Finding> findings, const Check& check,
                  const std::filesystem::path& folder);

// The error says which file could not be written; it is as it was, and so are
// those after it.
Expected<void> write_texts(const script::SourceTexts& texts);

// Puts the text in the file's place, its permissions kept; a file that a link
// stands for is replaced where it is.
Expected<void> replace_file(const std::filesystem::path& file,
                            const std::string& text);

} // namespace parlour::tools
