// Explains texts such as
//
//   <state name="A">            <state name="A">           <state name="A">
//     <Entrance>                  <Entrance>                 <Entrance>
//       <speak param="x">         </Entrence>                </Entrance>
//     </Entrance>               </state>                   <!-- no </state> -->
//   </state>
//
// namely a missing '/', a misspelt end tag and a missing end tag. The mistakes
// inside of tags come from tag_scanner; here the stack of open elements is
// followed.

#include "script/xml/xml_mistakes.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>

#include "script/source/findings.hpp"
#include "script/xml/element_table.hpp"
#include "script/xml/tag_scanner.hpp"

namespace parlour::script {

namespace {

constexpr auto npos = std::string_view::npos;
constexpr std::size_t max_mistakes = 100; // each may search the whole text

std::string tag(std::string_view name) {
  return "<" + std::string(name) + ">";
}

// A start tag whose end tag has not been found yet.
struct OpenTag {
  std::string name;
  std::size_t begin = 0;
  std::size_t end = 0; // offset of its '>'
  bool is_certain = true;
};

// Follows start and end tags through a text and reports those that do not
// match. Without a grammar a missing end tag cannot be told from a superfluous
// one; the open elements and the element table decide what is more likely.
class Nesting {
public:
  Nesting(std::string_view text, std::vector<XmlMistake>& mistakes)
      : text_(text), mistakes_(mistakes) {}

  void open(const ScannedTag& tag, std::size_t begin) {
    open_.push_back(
        {std::string(tag.name), begin, tag.end - 1, tag.is_certain});
  }
  void close(std::string_view name, std::size_t begin, std::size_t end);
  void finish();

private:
  void never_closed(const OpenTag& tag, const std::string& where,
                    std::size_t offset, std::size_t length);
  void unknown_end(std::string_view name, std::size_t begin, std::size_t end);
  void misspelt(std::string_view name, std::size_t begin, std::size_t end);
  // Whether an end tag of this name follows anywhere.
  bool ends_later(const OpenTag& open) const {
    return text_.find("</" + open.name, open.end) != npos;
  }
  std::string place_of(const OpenTag& open) const {
    const auto line = std::count(
        text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(open.begin),
        '\n');
    return tag(open.name) + " of line " + std::to_string(line + 1);
  }

  std::string_view text_;
  std::vector<XmlMistake>& mistakes_;
  std::vector<OpenTag> open_;
  // Elements whose end tag was reported as missing, and how often. If such an
  // end tag comes after all, it is skipped silently.
  std::map<std::string, std::size_t, std::less<>> dropped_;
};

// Reports an element without an end tag. If elements of that name are always
// empty, only the '/' is missing.
void Nesting::never_closed(const OpenTag& open, const std::string& where,
                           std::size_t offset, std::size_t length) {
  const bool is_empty = holds_nothing(open.name);
  if (mistakes_.size() >= max_mistakes || (is_empty && !open.is_certain))
    return;
  if (is_empty && text_[open.end] == '>') {
    mistakes_.push_back(
        {open.end, 1,
         tag(open.name) + " is not closed; it holds nothing and "
                          "ends with '/>'",
         ends_later(open) ? std::nullopt : std::optional<std::string>("/>")});
    return;
  }
  mistakes_.push_back(
      {offset, length,
       where + place_of(open) + " is open; expected </" + open.name + ">"});
}

// Reports an end tag that is a misspelling of the open one's. If just one of
// the two names is an element, that one is right and the other is corrected.
void Nesting::misspelt(std::string_view name, std::size_t begin,
                       std::size_t end) {
  const auto top = std::move(open_.back());
  open_.pop_back();
  const bool knows_begin = is_element_name(top.name),
             knows_end = is_element_name(name);
  if (!knows_begin && knows_end) {
    mistakes_.push_back({top.begin + 1, top.name.size(),
                         tag(top.name) + " does not fit its end tag </" +
                             std::string(name) + ">; expected " + tag(name),
                         std::string(name)});
    return;
  }
  mistakes_.push_back(
      {begin, end - begin,
       "</" + std::string(name) + "> does not fit: " + place_of(top) +
           " is open; expected </" + top.name + ">",
       knows_begin && !knows_end ? std::optional("</" + top.name + ">")
                                 : std::nullopt});
}

// Reports an end tag whose element is not open: a misspelling, or one too many.
void Nesting::unknown_end(std::string_view name, std::size_t begin,
                          std::size_t end) {
  if (mistakes_.size() >= max_mistakes)
    return;
  const auto shown = "</" + std::string(name) + ">";
  if (open_.empty()) {
    mistakes_.push_back(
        {begin, end - begin, shown + " closes nothing: no element is open"});
    return;
  }
  const auto& top = open_.back();
  if (top.is_certain && !nearest(name, {top.name}).empty())
    return misspelt(name, begin, end);
  mistakes_.push_back({begin, end - begin,
                       shown + " does not fit: " + place_of(top) +
                           " is open; expected </" + top.name + ">"});
}

// An end tag that matches an outer element closes the inner ones with it, and
// these are reported as never closed.
void Nesting::close(std::string_view name, std::size_t begin, std::size_t end) {
  const auto is_open = [&](const OpenTag& open) { return open.name == name; };
  const bool fits = !open_.empty() && is_open(open_.back());
  // The end tag of an element that was reported as never closed.
  const auto late = dropped_.find(name);
  if (!fits && late != dropped_.end() && late->second > 0) {
    --late->second;
    return;
  }
  if (!fits && std::none_of(open_.rbegin(), open_.rend(), is_open))
    return unknown_end(name, begin, end);
  // Everything inside of the element that ends here is closed with it.
  while (open_.back().name != name) {
    never_closed(open_.back(),
                 "</" + std::string(name) + "> does not fit: ", begin,
                 end - begin);
    ++dropped_[open_.back().name];
    open_.pop_back();
  }
  open_.pop_back();
}

// Reports what is still open at the end of the file. One missing end tag
// explains all elements around it, so only the innermost is reported, besides
// empty elements.
void Nesting::finish() {
  constexpr int max_elements = 200; // elements that are examined
  int looked = 0;
  bool told = false; // the elements around are explained by it
  for (; !open_.empty() && mistakes_.size() < max_mistakes &&
         looked < max_elements;
       open_.pop_back(), ++looked) {
    const auto& open = open_.back();
    const bool empty = holds_nothing(open.name);
    if (empty || !told)
      never_closed(open, "the file ends while ", text_.size(), 1);
    told |= !empty;
  }
}

} // namespace

// The corrections of tags come first, by scan_tag; their nesting is followed at
// the same time.
std::vector<XmlMistake> find_xml_mistakes(std::string_view text) {
  std::vector<XmlMistake> mistakes;
  Nesting nesting(text, mistakes);
  for (auto at = text.find('<'); at != npos && mistakes.size() < max_mistakes;
       at = text.find('<', at)) {
    const auto told = mistakes.size();
    const auto tag = scan_tag(text, at, mistakes);
    if (tag.kind == TagKind::other && tag.end == text.size() &&
        mistakes.size() > told)
      return mistakes; // the rest is inside of it
    if (tag.kind == TagKind::start)
      nesting.open(tag, at);
    else if (tag.kind == TagKind::end)
      nesting.close(tag.name, at, tag.end);
    at = std::max(tag.end, at + 1);
  }
  nesting.finish();
  std::stable_sort(
      mistakes.begin(), mistakes.end(),
      [](const auto& a, const auto& b) { return a.offset < b.offset; });
  return mistakes;
}

} // namespace parlour::script
