// The schema has a pattern for each row of the element table:
//
//   <define name="e12.speak">
//     <element>
//       <choice><name>speak</name><name>Speak</name></choice>
//       … attributes, children by <ref name="…"/>
//     </element>
//   </define>

#include "script/schema/relax_ng.hpp"

#include "script/schema/schema_names.hpp"
#include "script/schema/ways.hpp"
#include "script/schema/xml_writer.hpp"

namespace parlour::script {

namespace {

// Writes the schema row by row: each row of the table becomes a named pattern,
// to which the patterns of its parents refer.
class RelaxNg {
public:
  std::string schema();

private:
  void define(const ElementRule& rule);
  void name_class(const ElementRule& rule);
  void attribute(const WayAttribute& attribute, const ElementRule& rule);
  void attribute_name(const AttributeRule& attribute, const ElementRule& rule);
  void value(const AttributeRule& attribute);
  void content(const ElementRule& rule, const Way& way);
  void write(const ElementRule& rule, const Way& way);
  void refer(const ElementRule& rule) {
    xml_.empty("ref", {{"name", schema_name(rule)}});
  }
  void document(const std::string& text) {
    if (!text.empty())
      xml_.text("a:documentation", text);
  }

  XmlWriter xml_;
};

// "*" stands for every name without a row of its own at that place.
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

// "*" stands for every attribute that the row does not name.
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

// A choice of words, a pattern of the kind, or any text.
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

// An attribute is required, optional or, for "*", repeated.
void RelaxNg::attribute(const WayAttribute& one, const ElementRule& rule) {
  const auto& attribute = one.rule;
  const auto write = [&] {
    xml_.element("attribute", {}, [&] {
      attribute_name(attribute, rule);
      document(attribute.name == "*" ? "" : documentation(attribute));
      value(attribute);
    });
  };
  if (attribute.name == "*")
    xml_.element("zeroOrMore", {}, write);
  else if (one.required)
    write();
  else
    xml_.element("optional", {}, write);
}

namespace {

// What an element holds when it is written in one of its ways.
struct Content {
  std::vector<const ElementRule*> often;
  std::vector<const ElementRule*> once;
  std::vector<const ElementRule*> last;
  bool text = false;

  bool empty() const {
    return often.empty() && once.empty() && last.empty() && !text;
  }
};

// Sorts the possible children by how often they may occur.
Content content_of(const ElementRule& rule, const Way& way) {
  Content content;
  content.text = rule.holds_text() && !way.leaves_out("text");
  content.last.resize(rule.last.size());
  for (const auto* row : rows_within(rule.holds)) {
    if (const auto place = rule.last_place(row->name); place != 0)
      content.last[place - 1] = row;
    else if (!way.leaves_out(row->name))
      (rule.holds_once(row->name) ? content.once : content.often)
          .push_back(row);
  }
  return content;
}

} // namespace

// Children that occur once are interleaved with the others, as order does not
// matter; the last ones follow. A part may be followed by the statements that
// belong to it.
void RelaxNg::content(const ElementRule& rule, const Way& way) {
  const auto holds = content_of(rule, way);
  if (holds.empty())
    return xml_.empty("empty");
  // Text and children that may be repeated, in any order.
  const auto often = [&] {
    if (holds.often.empty() && !holds.text)
      return xml_.empty("empty");
    xml_.element("zeroOrMore", {}, [&] {
      xml_.element("choice", {}, [&] {
        if (holds.text)
          xml_.empty("text");
        for (const auto* row : holds.often)
          refer(*row);
      });
    });
  };
  if (holds.once.empty())
    often();
  else
    xml_.element("interleave", {}, [&] {
      often();
      for (const auto* row : holds.once)
        xml_.element("optional", {}, [&] { refer(*row); });
    });
  for (const auto* row : holds.last)
    xml_.element(rule.holds_once(row->name) ? "optional" : "zeroOrMore", {},
                 [&] {
                   refer(*row);
                   if (rule.in_parts)
                     often();
                 });
}

// Attributes first; in RELAX NG their order does not matter.
void RelaxNg::write(const ElementRule& rule, const Way& way) {
  for (const auto& one : way.attributes)
    attribute(one, rule);
  content(rule, way);
}

// An element with several ways is a choice between groups.
void RelaxNg::define(const ElementRule& rule) {
  xml_.element("define", {{"name", schema_name(rule)}}, [&] {
    xml_.element("element", {}, [&] {
      name_class(rule);
      document(documentation(rule));
      const auto ways = ways_of(rule);
      if (ways.size() == 1)
        return write(rule, ways.front());
      xml_.element("choice", {}, [&] {
        for (const auto& way : ways)
          xml_.element("group", {}, [&] { write(rule, way); });
      });
    });
  });
}

// A document begins with one of the roots.
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
