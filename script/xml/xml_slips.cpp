#include "script/xml/xml_slips.hpp"

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
constexpr std::size_t most_slips = 100; // each may cost a look at all the text

std::string tag(std::string_view name) {
  return "<" + std::string(name) + ">";
}

struct OpenTag {
  std::string name;
  std::size_t begin = 0;
  std::size_t end = 0; // of its '>'
  bool is_certain = true;
};

// Follows start and end tags through a text.
class Nesting {
public:
  Nesting(std::string_view text, std::vector<XmlSlip>& slips)
      : text_(text), slips_(slips) {}

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
  std::vector<XmlSlip>& slips_;
  std::vector<OpenTag> open_;
  // Whose end tag was told to be missing, and how often.
  std::map<std::string, std::size_t, std::less<>> dropped_;
};

void Nesting::never_closed(const OpenTag& open, const std::string& where,
                           std::size_t offset, std::size_t length) {
  const bool is_empty = holds_nothing(open.name);
  if (slips_.size() >= most_slips || (is_empty && !open.is_certain))
    return;
  if (is_empty && text_[open.end] == '>') {
    slips_.push_back(
        {open.end, 1,
         tag(open.name) + " is not closed; it holds nothing and "
                          "ends with '/>'",
         ends_later(open) ? std::nullopt : std::optional<std::string>("/>")});
    return;
  }
  slips_.push_back(
      {offset, length,
       where + place_of(open) + " is open; expected </" + open.name + ">"});
}

// An end tag that is nearly the open one's: of both, the name of an element is
// right, if one is.
void Nesting::misspelt(std::string_view name, std::size_t begin,
                       std::size_t end) {
  const auto top = std::move(open_.back());
  open_.pop_back();
  const bool knows_begin = is_element_name(top.name),
             knows_end = is_element_name(name);
  if (!knows_begin && knows_end) {
    slips_.push_back({top.begin + 1, top.name.size(),
                      tag(top.name) + " does not fit its end tag </" +
                          std::string(name) + ">; expected " + tag(name),
                      std::string(name)});
    return;
  }
  slips_.push_back(
      {begin, end - begin,
       "</" + std::string(name) + "> does not fit: " + place_of(top) +
           " is open; expected </" + top.name + ">",
       knows_begin && !knows_end ? std::optional("</" + top.name + ">")
                                 : std::nullopt});
}

// An end tag of what is not open: misspelt, or one too many.
void Nesting::unknown_end(std::string_view name, std::size_t begin,
                          std::size_t end) {
  if (slips_.size() >= most_slips)
    return;
  const auto shown = "</" + std::string(name) + ">";
  if (open_.empty()) {
    slips_.push_back(
        {begin, end - begin, shown + " closes nothing: no element is open"});
    return;
  }
  const auto& top = open_.back();
  if (top.is_certain && !nearest(name, {top.name}).empty())
    return misspelt(name, begin, end);
  slips_.push_back({begin, end - begin,
                    shown + " does not fit: " + place_of(top) +
                        " is open; expected </" + top.name + ">"});
}

void Nesting::close(std::string_view name, std::size_t begin, std::size_t end) {
  const auto is_open = [&](const OpenTag& open) { return open.name == name; };
  const bool fits = !open_.empty() && is_open(open_.back());
  const auto late = dropped_.find(name);
  if (!fits && late != dropped_.end() && late->second > 0) {
    --late->second;
    return;
  }
  if (!fits && std::none_of(open_.rbegin(), open_.rend(), is_open))
    return unknown_end(name, begin, end);
  while (open_.back().name != name) {
    never_closed(open_.back(),
                 "</" + std::string(name) + "> does not fit: ", begin,
                 end - begin);
    ++dropped_[open_.back().name];
    open_.pop_back();
  }
  open_.pop_back();
}

void Nesting::finish() {
  constexpr int most = 200; // elements that are looked at
  int looked = 0;
  bool told = false; // one end tag that is missing explains those around it
  for (; !open_.empty() && slips_.size() < most_slips && looked < most;
       open_.pop_back(), ++looked) {
    const auto& open = open_.back();
    const bool empty = holds_nothing(open.name);
    if (empty || !told)
      never_closed(open, "the file ends while ", text_.size(), 1);
    told |= !empty;
  }
}

} // namespace

std::vector<XmlSlip> find_xml_slips(std::string_view text) {
  std::vector<XmlSlip> slips;
  Nesting nesting(text, slips);
  for (auto at = text.find('<'); at != npos && slips.size() < most_slips;
       at = text.find('<', at)) {
    const auto told = slips.size();
    const auto tag = scan_tag(text, at, slips);
    if (tag.kind == TagKind::other && tag.end == text.size() &&
        slips.size() > told)
      return slips; // all that follows is inside of what does not end
    if (tag.kind == TagKind::start)
      nesting.open(tag, at);
    else if (tag.kind == TagKind::end)
      nesting.close(tag.name, at, tag.end);
    at = std::max(tag.end, at + 1);
  }
  nesting.finish();
  std::stable_sort(
      slips.begin(), slips.end(),
      [](const auto& a, const auto& b) { return a.offset < b.offset; });
  return slips;
}

} // namespace parlour::script
