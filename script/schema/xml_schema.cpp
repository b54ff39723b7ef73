#include "script/schema/xml_schema.hpp"

#include <algorithm>
#include <set>

#include "runtime/message/roles.hpp"
#include "script/schema/schema_names.hpp"
#include "script/schema/xml_writer.hpp"

namespace parlour::script {

namespace {

using Rows = std::vector<const ElementRule*>;

bool has_wildcard(const Rows& rows) {
  return std::any_of(rows.begin(), rows.end(),
                     [](const ElementRule* row) { return row->name == "*"; });
}

// Writes a type for each row. XSD fixes an element's type by its name and
// parent, which suits the table except for rows for any name (see globals).
class XmlSchema {
public:
  std::string schema();

private:
  void global(const std::string& name, const ElementRule& rule);
  void globals();
  void type(const ElementRule& rule);
  void content(const ElementRule& rule);
  void attribute(const AttributeRule& attribute);
  void value(const AttributeRule& attribute);
  void document(const std::string& text) {
    xml_.element("xs:annotation", {},
                 [&] { xml_.text("xs:documentation", text); });
  }

  XmlWriter xml_;
  std::set<std::string> global_;
};

// A global element has one type, so the first row with the name counts.
void XmlSchema::global(const std::string& name, const ElementRule& rule) {
  if (global_.insert(name).second)
    xml_.empty("xs:element", {{"name", name}, {"type", schema_name(rule)}});
}

// Wildcards stand for elements of any name, and a validator looks their
// elements up among the global ones. These are the sources and events of all
// roles, and the roots: <Dialogue> is a source, <dialogue> a root. An event of
// a statement's name ("wait", "confirm") is left out, as it may be either, and
// what is not among the global ones is accepted.
void XmlSchema::globals() {
  for (const auto& place : {"sources", "events"})
    for (const auto* row : rows_within({place})) {
      // A row for any name stands for all roles, or for all their events.
      if (row->name != "*") {
        for (const auto& name : spellings(row->name))
          global(name, *row);
        continue;
      }
      for (const auto& role : roles()) {
        if (std::string_view(place) == "events") {
          for (const auto& event : role.events)
            if (!find_rule(event.name, {"statements"}))
              global(event.name, *row);
          continue;
        }
        global(role.name, *row);
        for (const auto& alias : role.aliases)
          global(alias, *row);
      }
    }
  for (const auto* row : rows_within({"root"}))
    for (const auto& name : spellings(row->name))
      global(name, *row);
}

// XSD cannot limit how often single children occur in any order, so every child
// may be repeated.
void XmlSchema::content(const ElementRule& rule) {
  const auto rows = rows_within(rule.holds);
  if (rows.empty())
    return;
  xml_.element(
      "xs:choice", {{"minOccurs", "0"}, {"maxOccurs", "unbounded"}}, [&] {
        if (has_wildcard(rows))
          return xml_.empty(
              "xs:any", {{"processContents", is_free(rule) ? "skip" : "lax"}});
        for (const auto* row : rows)
          for (const auto& name : spellings(row->name))
            xml_.empty("xs:element",
                       {{"name", name}, {"type", schema_name(*row)}});
      });
}

// Words are enumerated, and other kinds have a pattern if there is one.
void XmlSchema::value(const AttributeRule& attribute) {
  xml_.element("xs:simpleType", {}, [&] {
    xml_.element("xs:restriction", {{"base", "xs:string"}}, [&] {
      for (const auto& word : words_of(attribute))
        xml_.empty("xs:enumeration", {{"value", word}});
      if (const auto pattern = pattern_of(attribute.kind); !pattern.empty())
        xml_.empty("xs:pattern", {{"value", pattern}});
    });
  });
}

// Attributes of any name are allowed by xs:anyAttribute instead.
void XmlSchema::attribute(const AttributeRule& attribute) {
  if (attribute.name == "*")
    return;
  xml_.element("xs:attribute",
               {{"name", attribute.name},
                {"use", attribute.required ? "required" : "optional"}},
               [&] {
                 document(documentation(attribute));
                 value(attribute);
               });
}

// Text between the children is allowed by mixed content.
void XmlSchema::type(const ElementRule& rule) {
  xml_.element("xs:complexType",
               {{"name", schema_name(rule)},
                {"mixed", rule.holds_text() ? "true" : "false"}},
               [&] {
                 document(documentation(rule));
                 content(rule);
                 for (const auto& one : rule.attributes)
                   attribute(one);
                 if (rule.attribute("*"))
                   xml_.empty("xs:anyAttribute", {{"processContents", "skip"}});
               });
}

// Global elements come first, then a type for each row.
std::string XmlSchema::schema() {
  xml_.element("xs:schema", {{"xmlns:xs", "http://www.w3.org/2001/XMLSchema"}},
               [&] {
                 globals();
                 for (const auto& rule : element_table())
                   type(rule);
               });
  return xml_.take();
}

} // namespace

std::string xml_schema() {
  return XmlSchema().schema();
}

} // namespace parlour::script
