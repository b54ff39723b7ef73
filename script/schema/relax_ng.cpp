#include "script/schema/relax_ng.hpp"

#include "script/schema/schema_names.hpp"
#include "script/schema/xml_writer.hpp"

namespace parlour::script {

namespace {

class RelaxNg {
public:
  std::string schema();

private:
  void define(const ElementRule& rule);
  void name_class(const ElementRule& rule);
  void attribute(const AttributeRule& attribute, const ElementRule& rule);
  void attribute_name(const AttributeRule& attribute, const ElementRule& rule);
  void value(const AttributeRule& attribute);
  void content(const ElementRule& rule);
  void document(const std::string& text) {
    if (!text.empty())
      xml_.text("a:documentation", text);
  }

  XmlWriter xml_;
};

// "*" stands for every name that no other row of its place has.
void RelaxNg::name_class(const ElementRule& rule) {
  if (rule.name != "*")
    return xml_.element("choice", {}, [&] {
      for (const auto& name : spellings(rule.name))
        xml_.text("name", name);
    });
  std::vector<std::string> others;
  for (const auto* other : rows_within(rule.in))
    if (other->name != "*")
      for (const auto& name : spellings(other->name))
        others.push_back(name);
  if (others.empty())
    return xml_.empty("anyName");
  xml_.element("anyName", {}, [&] {
    xml_.element("except", {}, [&] {
      for (const auto& name : others)
        xml_.text("name", name);
    });
  });
}

void RelaxNg::attribute_name(const AttributeRule& attribute,
                             const ElementRule& rule) {
  if (attribute.name != "*")
    return xml_.text("name", attribute.name);
  if (rule.attribute_names().empty())
    return xml_.empty("anyName");
  xml_.element("anyName", {}, [&] {
    xml_.element("except", {}, [&] {
      for (const auto& name : rule.attribute_names())
        xml_.text("name", name);
    });
  });
}

void RelaxNg::value(const AttributeRule& attribute) {
  const auto pattern = pattern_of(attribute.kind);
  const auto words = words_of(attribute);
  if (!words.empty())
    return xml_.element("choice", {}, [&] {
      for (const auto& word : words)
        xml_.text("value", word, {{"type", "string"}});
    });
  if (pattern.empty())
    return xml_.empty("text");
  xml_.element("data", {{"type", "string"}}, [&] {
    xml_.text("param", pattern, {{"name", "pattern"}});
  });
}

void RelaxNg::attribute(const AttributeRule& attribute,
                        const ElementRule& rule) {
  const auto write = [&] {
    xml_.element("attribute", {}, [&] {
      attribute_name(attribute, rule);
      document(attribute.name == "*" ? "" : documentation(attribute));
      value(attribute);
    });
  };
  if (attribute.name == "*")
    xml_.element("zeroOrMore", {}, write);
  else if (attribute.required)
    write();
  else
    xml_.element("optional", {}, write);
}

void RelaxNg::content(const ElementRule& rule) {
  const auto rows = rows_within(rule.holds);
  if (rows.empty() && !rule.holds_text())
    return xml_.empty("empty");
  xml_.element("zeroOrMore", {}, [&] {
    xml_.element("choice", {}, [&] {
      if (rule.holds_text())
        xml_.empty("text");
      for (const auto* row : rows)
        xml_.empty("ref", {{"name", schema_name(*row)}});
    });
  });
}

void RelaxNg::define(const ElementRule& rule) {
  xml_.element("define", {{"name", schema_name(rule)}}, [&] {
    xml_.element("element", {}, [&] {
      name_class(rule);
      document(documentation(rule));
      for (const auto& one : rule.attributes)
        attribute(one, rule);
      content(rule);
    });
  });
}

std::string RelaxNg::schema() {
  xml_.element(
      "grammar",
      {{"xmlns", "http://relaxng.org/ns/structure/1.0"},
       {"xmlns:a", "http://relaxng.org/ns/compatibility/annotations/1.0"},
       {"datatypeLibrary", "http://www.w3.org/2001/XMLSchema-datatypes"}},
      [&] {
        xml_.element("start", {}, [&] {
          xml_.element("choice", {}, [&] {
            for (const auto* row : rows_within({"root"}))
              xml_.empty("ref", {{"name", schema_name(*row)}});
          });
        });
        for (const auto& rule : element_table())
          define(rule);
      });
  return xml_.take();
}

} // namespace

std::string relax_ng_schema() {
  return RelaxNg().schema();
}

} // namespace parlour::script
