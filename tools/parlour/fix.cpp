#include "tools/parlour/fix.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <map>
#include <utility>

#include <unistd.h>

#include "script/source_reader.hpp"

namespace parlour::tools {

namespace {

namespace fs = std::filesystem;

bool overlaps(const script::Edit& edit, const std::vector<script::Edit>& all) {
  return std::any_of(all.begin(), all.end(), [&](const script::Edit& other) {
    return edit.range.begin <
               std::max(other.range.end, other.range.begin + 1) &&
           other.range.begin < std::max(edit.range.end, edit.range.begin + 1);
  });
}

bool is_below(const fs::path& file, const fs::path& folder) {
  std::error_code ignored;
  const auto relative =
      fs::weakly_canonical(file, ignored)
          .lexically_relative(fs::weakly_canonical(folder, ignored));
  return !relative.empty() && *relative.begin() != "..";
}

tl::unexpected<Error> cannot_write(const fs::path& file,
                                   const std::string& why) {
  return fail(ErrorKind::file, "'" + file.string() + "' cannot be written (" +
                                   why + "); it is as it was");
}

// Empty, or why it is not there now.
std::error_code write_anew(const fs::path& file, const std::string& text) {
  errno = 0; // a stream tells no reason
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out << text;
  out.close();
  return {out ? 0 : errno ? errno : EIO, std::generic_category()};
}

} // namespace

std::string apply_fixes(std::string text,
                        const std::vector<script::Finding>& findings,
                        std::vector<script::Finding>& fixed) {
  std::vector<script::Edit> edits;
  for (const auto& finding : findings) {
    const auto& fix = finding.fix;
    if (fix.empty() ||
        std::any_of(fix.begin(), fix.end(), [&](const script::Edit& edit) {
          return edit.range.end > text.size() || overlaps(edit, edits);
        }))
      continue;
    edits.insert(edits.end(), fix.begin(), fix.end());
    fixed.push_back(finding);
  }
  std::sort(edits.begin(), edits.end(), [](const auto& a, const auto& b) {
    return a.range.begin > b.range.begin;
  });
  for (const auto& [range, instead] : edits)
    text.replace(range.begin, range.end - range.begin, instead);
  return text;
}

Expected<void> replace_file(const fs::path& path, const std::string& text) {
  std::error_code wrong;
  const auto file = fs::canonical(path, wrong);
  if (wrong)
    return cannot_write(path, wrong.message());
  const fs::path temporary =
      file.string() + ".parlour-" + std::to_string(getpid());
  const auto status = fs::status(file, wrong);
  if (!wrong)
    wrong = write_anew(temporary, text);
  if (!wrong)
    fs::permissions(temporary, status.permissions(), wrong);
  if (!wrong)
    fs::rename(temporary, file, wrong);
  if (!wrong)
    return {};
  std::error_code ignored;
  fs::remove(temporary, ignored);
  return cannot_write(path, wrong.message());
}

Expected<std::vector<FixedFile>>
fix_files(const std::vector<script::Finding>& findings,
          const fs::path& folder) {
  std::map<std::string, std::vector<script::Finding>> of_file;
  for (const auto& finding : findings)
    if (!finding.fix.empty() && is_below(finding.place.file, folder))
      of_file[finding.place.file].push_back(finding);
  std::vector<FixedFile> all;
  for (const auto& [file, its] : of_file) {
    auto text = script::read_bytes(file);
    if (!text)
      return tl::make_unexpected(text.error());
    FixedFile done{file, {}};
    auto written =
        replace_file(file, apply_fixes(std::move(*text), its, done.fixed));
    if (!written)
      return tl::make_unexpected(written.error());
    all.push_back(std::move(done));
  }
  return all;
}

} // namespace parlour::tools
