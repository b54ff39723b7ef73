// Renaming works on the text, not on the tree, as a quick fix must change
// exactly the bytes of the names.

#include "script/xml/tag_rename.hpp"

#include <string_view>

#include "script/xml/tag_scanner.hpp"

namespace parlour::script {

namespace {

// The end tag of the element whose start tag ends at `from`; npos if there is
// none. Counts the depth of tags and ignores their names.
std::size_t find_end_tag(std::string_view text, std::size_t from) {
  std::vector<XmlMistake> mistakes;
  int depth = 1;
  for (auto at = text.find('<', from); at != std::string_view::npos;
       at = text.find('<', at)) {
    const auto tag = scan_tag(text, at, mistakes);
    depth += tag.kind == TagKind::start ? 1 : tag.kind == TagKind::end ? -1 : 0;
    if (depth == 0)
      return at;
    at = tag.end;
  }
  return std::string_view::npos;
}

} // namespace

std::vector<Edit> rename_tags(const std::string& text, std::size_t begin,
                              const std::string& name) {
  std::vector<XmlMistake> mistakes;
  if (begin >= text.size() || text[begin] != '<')
    return {};
  const auto tag = scan_tag(text, begin, mistakes);
  const auto length = tag.name.size();
  if (length == 0 || !mistakes.empty())
    return {};
  std::vector<Edit> edits{{{begin + 1, begin + 1 + length}, name}};
  if (tag.kind == TagKind::empty)
    return edits;
  const auto end = find_end_tag(text, tag.end);
  if (end == std::string_view::npos || text.substr(end + 2, length) != tag.name)
    return {};
  edits.push_back({{end + 2, end + 2 + length}, name});
  return edits;
}

} // namespace parlour::script
