#include "adapters/files/file_list.hpp"

#include <algorithm>
#include <utility>

#include "adapters/files/encoding.hpp"
#include "adapters/files/folder.hpp"
#include "adapters/files/name_pattern.hpp"

namespace parlour::adapters {

namespace {

// In one folder. Bounds the memory.
constexpr std::size_t max_entries = 100'000;

// Descends into the folders that fit, level by level of the pattern.
class Search {
public:
  Search(const std::vector<std::string>& pattern, std::size_t max_bytes)
      : pattern_(pattern), left_(max_bytes) {}

  // Matches part `level` of the pattern in `folder`; `way` is the name of the
  // folder. What disappears during the search is not listed.
  Expected<void> look(const Folder& folder, std::size_t level,
                      const std::string& way) {
    auto names = folder.names(max_entries);
    if (!names)
      return tl::make_unexpected(names.error());
    for (const auto& name : *names)
      if (fits_pattern(pattern_[level], name) && is_utf8(name))
        if (auto looked = take(folder, level, way, name); !looked)
          return looked;
    return {};
  }

  Value found() {
    std::sort(found_.begin(), found_.end());
    return List(found_.begin(), found_.end());
  }

private:
  // The last part of the pattern names files, the others folders.
  Expected<void> take(const Folder& folder, std::size_t level,
                      const std::string& way, const std::string& name) {
    const bool last = level + 1 == pattern_.size();
    if (folder.what(name) != (last ? Folder::What::file : Folder::What::folder))
      return {};
    if (!last) {
      const auto below = folder.folder(name, Missing::refuse);
      return below ? look(*below, level + 1, way + name + '/')
                   : Expected<void>();
    }
    auto whole = way + name;
    if (whole.size() > left_)
      return fail(ErrorKind::file, "there are too many files to list");
    left_ -= whole.size();
    found_.push_back(std::move(whole));
    return {};
  }

  const std::vector<std::string>& pattern_;
  std::size_t left_;
  std::vector<std::string> found_;
};

} // namespace

Expected<Value> list_files(const std::filesystem::path& data,
                           const std::vector<std::string>& pattern,
                           std::size_t max_bytes) {
  std::error_code ignored;
  // symlink_status: a data folder that is a link is not "missing" but refused
  // by open().
  if (!std::filesystem::exists(std::filesystem::symlink_status(data, ignored)))
    return Value(List{});
  const auto folder = Folder::open(data, Missing::refuse);
  if (!folder)
    return tl::make_unexpected(folder.error());
  Search search(pattern, max_bytes);
  if (auto looked = search.look(*folder, 0, ""); !looked)
    return tl::make_unexpected(looked.error());
  return search.found();
}

} // namespace parlour::adapters
