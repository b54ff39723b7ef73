// `parlour check --fix`: applies the corrections that findings offer.
//
// A correction is kept only if the application is no worse afterwards, as
// `check` sees it. A file is replaced as a whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "script/compiler/application/application_loader.hpp"
#include "script/source/findings.hpp"

namespace parlour::tools {

// Checks the application as if these texts stood in their files.
using Check =
    std::function<std::vector<script::Finding>(const script::SourceTexts&)>;

struct Corrected {
  script::SourceTexts texts;             // new texts of the files that change
  std::vector<script::Finding> made;     // what was corrected
  std::vector<script::Finding> findings; // what remains
};

// Applies the corrections of `findings`, which all concern the file with this
// text, and returns the new text. Appends to `fixed` the findings that were
// corrected: of two whose edits overlap, only the first is.
std::string apply_fixes(std::string text,
                        const std::vector<script::Finding>& findings,
                        std::vector<script::Finding>& fixed);

// Whether a correction did harm: there are more errors; or there were none, and
// there are more findings (errors hide warnings, so otherwise their number says
// nothing); or a file is no longer well-formed XML.
bool is_worse(const std::vector<script::Finding>& findings,
              const std::vector<script::Finding>& before);

// Corrects as much as possible in the files below `folder`. Calls `check` up to
// some 200 times. Changes no file.
Corrected correct(std::vector<script::Finding> findings, const Check& check,
                  const std::filesystem::path& folder);

// Writes the texts to their files. On an error, which names the file, that file
// and those after it are unchanged; those before it are written.
Expected<void> write_texts(const script::SourceTexts& texts);

// Replaces a file's contents atomically, by a new file and a rename, and keeps
// its permissions. If `file` is a link, its target is replaced.
Expected<void> replace_file(const std::filesystem::path& file,
                            const std::string& text);

} // namespace parlour::tools
