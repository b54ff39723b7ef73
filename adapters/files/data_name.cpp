#include "adapters/files/data_name.hpp"

#include <algorithm>

#include "runtime/base/text/utf8.hpp"

namespace parlour::adapters {

namespace {

// Limits of file systems on Linux: 255 bytes in a part, 4,096 in a path.
constexpr std::size_t longest_part = 255;
constexpr std::size_t longest_name = 4'000;
constexpr std::size_t longest_shown = 80;

bool is_control(char c) {
  return static_cast<unsigned char>(c) < ' ' || c == '\x7f';
}

// What is wrong with a part, or null.
const char* fault(std::string_view part) {
  if (part.empty())
    return "has an empty part; write it without a '/' at the beginning, at the "
           "end, or doubled";
  if (part == "." || part == "..")
    return "leads out of the data folder; name a file inside of it";
  if (part.front() == '.')
    return "has a part that begins with a dot; such files are the platform's "
           "own";
  if (std::any_of(part.begin(), part.end(), is_control))
    return "has a control character in it";
  if (part.find('\\') != std::string_view::npos)
    return "has a backslash in it; folders are separated by '/'";
  return part.size() > longest_part ? "is too long" : nullptr;
}

tl::unexpected<Error> wrong(std::string_view name, const char* what) {
  return fail(ErrorKind::file,
              "the file name " + shown_name(name) + ' ' + what);
}

} // namespace

Expected<std::vector<std::string>> split_name(std::string_view name) {
  if (name.size() > longest_name)
    return wrong(name, "is too long");
  if (name.starts_with('/'))
    return wrong(name, "is absolute; names begin in the data folder");
  std::vector<std::string> parts;
  for (auto rest = name;;) {
    const auto slash = rest.find('/');
    const auto part = rest.substr(0, slash);
    if (const auto* what = fault(part))
      return wrong(name, what);
    parts.emplace_back(part);
    if (slash == std::string_view::npos)
      return parts;
    rest.remove_prefix(slash + 1);
  }
}

std::string shown_name(std::string_view name) {
  std::string shown(name.substr(0, longest_shown));
  // A character is not cut in two.
  while (shown.size() < name.size() && !shown.empty() &&
         continues_code_point(name[shown.size()]))
    shown.pop_back();
  std::replace_if(shown.begin(), shown.end(), is_control, '?');
  return '\'' + shown + (shown.size() < name.size() ? "…'" : "'");
}

} // namespace parlour::adapters
