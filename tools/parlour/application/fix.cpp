// The search for corrections that do no harm.
//
// First all corrections are tried together. If the application is worse then,
// the new corrections that this made possible are tried as well (settle). If
// that does not help, the set is halved and each half is tried by itself, down
// to single corrections (attempt_halves). Rounds repeat this until nothing
// changes.
#include "tools/parlour/application/fix.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include <unistd.h>

#include "script/xml/source_reader.hpp"

namespace parlour::tools {

namespace {

namespace fs = std::filesystem;
using Findings = std::vector<script::Finding>;

constexpr int max_rounds = 10;
// Each check compiles and lints the whole application.
constexpr int max_checks = 200;

// Whether an edit shares a byte with others. An insertion counts as one byte
// long, so that two insertions at the same place overlap.
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

std::size_t errors(const Findings& findings) {
  return static_cast<std::size_t>(std::count_if(
      findings.begin(), findings.end(), [](const script::Finding& one) {
        return one.severity == script::Severity::error;
      }));
}

// Files that are not well-formed XML.
std::set<std::string> broken_files(const Findings& findings) {
  std::set<std::string> files;
  for (const auto& finding : findings)
    if (finding.name == "xml")
      files.insert(finding.place.file);
  return files;
}

// One run of correct(). `done_` is the best state so far: its texts, the
// corrections made and the findings that remain.
// All of it is bounded by `max_checks`, as a check takes the time of a
// compilation.
class Correcting {
public:
  Correcting(Findings findings, const Check& check, const fs::path& folder)
      : check_(check), folder_(folder), done_{{}, {}, std::move(findings)} {}

  Corrected run();

private:
  // Findings with a correction in a file below the folder.
  Findings fixable(const Corrected& state) const;
  // The state after more corrections, checked.
  Corrected with(const Corrected& state, const Findings& fixes);
  // Applies further corrections until `tried` is no worse than `done_`; false
  // if that does not succeed.
  bool settle(Corrected& tried);
  // Tries corrections. True if the base has changed, so that the places in the
  // remaining findings are no longer valid and the round must end.
  bool attempt(const Findings& fixes);
  // The same for two halves of a set that failed.
  bool attempt_halves(const Findings& fixes);

  const Check& check_;
  const fs::path& folder_;
  Corrected done_;
  // The state when the round began: the places of `accepted_` and of the fixes
  // in this round refer to its texts.
  Corrected base_;
  Findings accepted_; // corrections of this round that are kept
  int checks_ = 0;    // calls of `check_` so far
};

Corrected Correcting::run() {
  for (int round = 0; round < max_rounds; ++round) {
    const auto before = done_.made.size();
    base_ = done_;
    accepted_.clear();
    if (const auto fixes = fixable(done_); !fixes.empty())
      attempt(fixes);
    if (done_.made.size() == before)
      break;
  }
  return std::move(done_);
}

Findings Correcting::fixable(const Corrected& state) const {
  Findings fixes;
  std::copy_if(state.findings.begin(), state.findings.end(),
               std::back_inserter(fixes), [this](const auto& finding) {
                 return !finding.fix.empty() &&
                        is_below(finding.place.file, folder_);
               });
  return fixes;
}

// Groups the corrections by file and applies them to the current texts.
Corrected Correcting::with(const Corrected& state, const Findings& fixes) {
  std::map<std::string, Findings> of_file;
  for (const auto& fix : fixes)
    of_file[fix.place.file].push_back(fix);
  auto next = state;
  for (const auto& [file, its] : of_file) {
    auto [text, is_new] = next.texts.try_emplace(file);
    if (is_new)
      text->second = script::read_bytes(file).value_or("");
    text->second = apply_fixes(std::move(text->second), its, next.made);
  }
  ++checks_;
  next.findings = check_(next.texts);
  return next;
}

// A correction may uncover mistakes that have corrections themselves.
bool Correcting::settle(Corrected& tried) {
  for (int round = 0; round < max_rounds; ++round) {
    if (!is_worse(tried.findings, done_.findings))
      return true;
    const auto fixes = fixable(tried);
    if (fixes.empty() || checks_ > max_checks)
      return false;
    tried = with(tried, fixes);
  }
  return false;
}

// The places of all fixes in a round refer to `base_`, so they can be combined.
// After settle() has changed the texts further, they no longer do.
bool Correcting::attempt(const Findings& fixes) {
  auto all = accepted_;
  all.insert(all.end(), fixes.begin(), fixes.end());
  auto tried = with(base_, all);
  if (!is_worse(tried.findings, done_.findings)) {
    accepted_ = std::move(all);
    done_ = std::move(tried);
    return false;
  }
  if (settle(tried)) {
    done_ = std::move(tried);
    return true;
  }
  return attempt_halves(fixes);
}

bool Correcting::attempt_halves(const Findings& fixes) {
  if (fixes.size() == 1 || checks_ > max_checks)
    return false;
  const auto middle =
      fixes.begin() + static_cast<std::ptrdiff_t>(fixes.size() / 2);
  return attempt({fixes.begin(), middle}) || attempt({middle, fixes.end()});
}

tl::unexpected<Error> cannot_write(const fs::path& file,
                                   const std::string& why) {
  return fail(ErrorKind::file, "'" + file.string() + "' cannot be written (" +
                                   why + "); it is as it was");
}

// Writes a new file; the error is empty if that succeeded.
std::error_code write_anew(const fs::path& file, const std::string& text) {
  errno = 0; // a stream gives no reason
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out << text;
  out.close();
  return {out ? 0 : errno ? errno : EIO, std::generic_category()};
}

} // namespace

std::string apply_fixes(std::string text,
                        const std::vector<script::Finding>& findings,
                        std::vector<script::Finding>& fixed) {
  // Edits are collected first and applied from the back to the front, so that
  // earlier offsets stay valid.
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

bool is_worse(const Findings& findings, const Findings& before) {
  const auto broken = broken_files(findings),
             broken_before = broken_files(before);
  const bool shows_more =
      errors(before) == 0 && findings.size() > before.size();
  return shows_more || errors(findings) > errors(before) ||
         !std::includes(broken_before.begin(), broken_before.end(),
                        broken.begin(), broken.end());
}

Corrected correct(Findings findings, const Check& check,
                  const fs::path& folder) {
  return Correcting(std::move(findings), check, folder).run();
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

Expected<void> write_texts(const script::SourceTexts& texts) {
  for (const auto& [file, text] : texts)
    if (auto written = replace_file(file, text); !written)
      return written;
  return {};
}

} // namespace parlour::tools
