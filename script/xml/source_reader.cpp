// Reading XML by pugixml, which is fast and lenient. It parses in place, into
// `buffer_`, and keeps no positions; offsets are recovered from the addresses
// of names and values, which point into the buffer.

#include "script/xml/source_reader.hpp"

#include <cstring>
#include <utility>

#include <pugixml.hpp>

#include "runtime/base/outside/file_bytes.hpp"
#include "runtime/base/text/utf8.hpp"
#include "script/source/text_positions.hpp"
#include "script/xml/well_formed.hpp"

namespace parlour::script {

namespace {

constexpr auto npos = std::string_view::npos;
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
// Parsed as a fragment, so that text outside of the root is kept and can be
// reported.
constexpr auto parse_options =
    pugi::parse_default | pugi::parse_doctype | pugi::parse_fragment;

// What the parser expected where it gave up. Tags that do not match are
// explained elsewhere (xml_mistakes.hpp).
const char* sentence_of(pugi::xml_parse_status status) {
  switch (status) {
  case pugi::status_bad_pi:
    return "this <?…?> does not end; expected ?>";
  case pugi::status_bad_comment:
    return "this comment does not end; expected -->";
  case pugi::status_bad_cdata:
    return "this CDATA section does not end; expected ]]>";
  case pugi::status_bad_doctype:
    return "a DOCTYPE may not stand in a script";
  case pugi::status_bad_start_element:
    return "this tag is not well-formed; expected <name attribute=\"value\">";
  case pugi::status_bad_attribute:
    return "this attribute is not well-formed; expected name=\"value\" with "
           "the same quotes around it and none of them inside";
  case pugi::status_bad_end_element:
    return "this end tag is not well-formed; expected </name>";
  case pugi::status_no_document_element:
    return "there is no element in this file";
  default:
    return "this is not well-formed XML";
  }
}

// Reads one file, in this order: characters, pugixml, what stands outside of
// the root, faults that pugixml accepts, and then the tree. Offsets found in
// the buffer are offsets in the text, as pugixml parses in place and never
// moves a byte to the right.
class Reader {
public:
  Reader(std::string text, std::uint16_t file, Findings& findings)
      : text_(std::move(text)), positions_(text_, file), findings_(findings) {}

  std::optional<Element> read();

private:
  void check_byte_order_marks();
  void check_text();
  pugi::xml_parse_result parse();
  std::size_t beginning(pugi::xml_parse_status status,
                        std::size_t offset) const;
  void explain(const pugi::xml_parse_result& result);
  void check_document();
  void build(pugi::xml_node node, Element& element, std::size_t depth);
  void read_attributes(pugi::xml_node node, Element& element);
  void read_text(pugi::xml_node node, Element& element);
  void check_name(const char* name, std::size_t offset);
  void error(std::size_t offset, std::string message);
  // Reports a mistake after which reading can go on.
  void tell(const XmlMistake& mistake);
  std::size_t offset_of(const char* inside) const {
    return static_cast<std::size_t>(inside - buffer_.data());
  }

  std::string text_;   // as in the file
  std::string buffer_; // a copy, which the parser overwrites in place
  TextPositions positions_;
  Findings& findings_;
  pugi::xml_document document_;
  bool failed_ = false;
};

// A mistake after which no tree is returned.
void Reader::error(std::size_t offset, std::string message) {
  failed_ = true;
  tell({offset, 0, std::move(message)});
}

void Reader::tell(const XmlMistake& mistake) {
  findings_.add({Severity::error,
                 {.start = positions_.at(mistake.offset),
                  .length = mistake.length,
                  .raw = true},
                 mistake.message,
                 "xml",
                 mistake.replacement});
}

// The first byte order mark was removed already; further ones are mistakes.
void Reader::check_byte_order_marks() {
  std::size_t end = 0;
  while (std::string_view(text_).substr(end).starts_with(byte_order_mark))
    end += byte_order_mark.size();
  if (end == 0)
    return;
  failed_ = true;
  tell({0, end, "a second byte order mark begins this file; take it out", ""});
}

// Problems of the characters come first, since the parser would stumble over
// them at misleading places.
void Reader::check_text() {
  check_byte_order_marks();
  if (const auto invalid = find_invalid_utf8(text_))
    return error(*invalid, "this is not UTF-8; save the file as UTF-8");
  if (const auto control = find_control_character(text_))
    return error(*control, "a control character may not stand in XML; take it "
                           "out");
  for (const auto* none : {"\xef\xbf\xbe", "\xef\xbf\xbf"}) // U+FFFE, U+FFFF
    if (const auto found = text_.find(none); found != npos)
      return error(found, "what stands here is no character; take it out");
}

// The terminating null is part of the buffer: the parser overwrites the last
// character, and would otherwise lose a text of one character behind the root.
pugi::xml_parse_result Reader::parse() {
  auto result = document_.load_buffer_inplace(
      buffer_.data(), buffer_.size() + 1, parse_options, pugi::encoding_utf8);
  if (result && !document_.document_element()) {
    result.status = pugi::status_no_document_element;
    result.offset = text_.empty() ? 0 : std::ssize(text_) - 1;
  }
  return result;
}

// Something without an end is reported where it begins, not at the end of the
// file, where the parser notices.
std::size_t Reader::beginning(pugi::xml_parse_status status,
                              std::size_t offset) const {
  const char* opening = status == pugi::status_bad_comment   ? "<!--"
                        : status == pugi::status_bad_cdata   ? "<![CDATA["
                        : status == pugi::status_bad_pi      ? "<?"
                        : status == pugi::status_bad_doctype ? "<!"
                                                             : nullptr;
  const auto found = opening ? text_.rfind(opening, offset) : npos;
  return found == npos ? offset : found;
}

// The scanner of our own finds all mistakes and their corrections. If it finds
// none, the parser's single error is translated.
void Reader::explain(const pugi::xml_parse_result& result) {
  const auto offset = static_cast<std::size_t>(result.offset);
  const auto mistakes = find_xml_mistakes(text_);
  for (const auto& mistake : mistakes)
    tell(mistake);
  failed_ = true;
  if (mistakes.empty())
    error(beginning(result.status, offset), sentence_of(result.status));
}

// Namespaces have no meaning here, so a prefix is a mistake.
void Reader::check_name(const char* name, std::size_t offset) {
  if (std::strchr(name, ':'))
    error(offset, "'" + std::string(name) +
                      "' has a prefix; names here have "
                      "none");
}

// A repeated attribute is reported, but it does not keep the file from being
// read: the first one counts.
void Reader::read_attributes(pugi::xml_node node, Element& element) {
  std::size_t count = 0;
  for (auto attribute = node.first_attribute(); attribute;
       attribute = attribute.next_attribute())
    ++count;
  element.attributes.reserve(count);
  for (auto attribute = node.first_attribute(); attribute;
       attribute = attribute.next_attribute()) {
    const auto at = offset_of(attribute.name());
    const auto value_at = offset_of(attribute.value());
    check_name(attribute.name(), at);
    if (element.attribute(attribute.name()))
      tell({at, 0,
            "'" + std::string(attribute.name()) +
                "' is given twice; leave one of them out"});
    element.attributes.push_back({attribute.name(), attribute.value(),
                                  positions_.at(at), positions_.at(value_at)});
  }
}

// Several texts between children are joined; the position is that of the first.
void Reader::read_text(pugi::xml_node node, Element& element) {
  const auto offset = offset_of(node.value());
  if (element.text.empty()) {
    const auto first = text_.find_first_not_of(" \t\r\n", offset);
    element.text_position = positions_.at(first);
  }
  element.text += node.value();
}

// Recursion is safe: `deepest_elements` limits it, and pugixml itself parses
// without recursion. Children are counted first, because growing a vector of
// elements would move whole subtrees.
void Reader::build(pugi::xml_node node, Element& element, std::size_t depth) {
  const auto offset = offset_of(node.name()) - 1; // of the `<`
  element.name = node.name();
  element.position = positions_.at(offset);
  check_name(node.name(), offset);
  if (depth > deepest_elements)
    return error(offset, "elements are nested deeper than " +
                             std::to_string(deepest_elements) + " levels");
  read_attributes(node, element);
  std::size_t count = 0;
  for (auto child = node.first_child(); child; child = child.next_sibling())
    count += child.type() == pugi::node_element;
  element.children.reserve(count);
  for (auto child = node.first_child(); child; child = child.next_sibling()) {
    if (child.type() == pugi::node_element)
      build(child, element.children.emplace_back(), depth + 1);
    else if (child.type() == pugi::node_pcdata ||
             child.type() == pugi::node_cdata)
      read_text(child, element);
    else if (child.type() == pugi::node_doctype)
      error(offset, sentence_of(pugi::status_bad_doctype));
  }
}

// A fragment may have several roots and text between them; both are reported
// here.
void Reader::check_document() {
  int roots = 0;
  auto outside = npos;
  for (auto node : document_.children()) {
    if (node.type() == pugi::node_doctype)
      error(beginning(pugi::status_bad_doctype, offset_of(node.value())),
            sentence_of(pugi::status_bad_doctype));
    // Further roots are consequences of the second one.
    if (node.type() == pugi::node_element && ++roots == 2)
      error(offset_of(node.name()) - 1,
            "a second root element; a file has one");
    if (node.type() == pugi::node_cdata && outside == npos)
      outside = offset_of(node.value()) - std::string_view("<![CDATA[").size();
    if (node.type() == pugi::node_pcdata && outside == npos)
      outside = text_.find_first_not_of(" \t\r\n", offset_of(node.value()));
  }
  if (outside != npos)
    error(outside, "text outside of the root element");
}

// Errors of the characters end reading at once; later ones are collected.
std::optional<Element> Reader::read() {
  check_text();
  if (failed_)
    return std::nullopt;
  buffer_ = text_;
  if (const auto result = parse(); !result) {
    explain(result);
    return std::nullopt;
  }
  check_document();
  for (const auto& fault : find_faults(text_))
    tell(fault);
  Element root;
  build(document_.document_element(), root, 1);
  if (failed_)
    return std::nullopt;
  return root;
}

} // namespace

std::optional<Element> read_source(std::string text, std::uint16_t file,
                                   Findings& findings) {
  if (text.size() > largest_source) {
    findings.error({file, 0, 0}, "the file is larger than 16 MB");
    return std::nullopt;
  }
  if (text.starts_with(byte_order_mark)) // has no meaning
    text.erase(0, byte_order_mark.size());
  return Reader(std::move(text), file, findings).read();
}

Expected<std::string> read_bytes(const std::filesystem::path& path) {
  return read_file(path, largest_source);
}

} // namespace parlour::script
