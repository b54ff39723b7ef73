// unknown-field: a field of a value that is known to have no such field.
//
//   <querydb param="select name from staff" return="r"/>
//   <print param="{r.name}"/>             write r.rows[0].name
#include <algorithm>
#include <map>
#include <optional>

#include "script/lint/passes.hpp"
#include "script/xml/attribute_check.hpp"

namespace parlour::script::lint {

namespace {

// What a variable certainly holds, judging by all statements that write it.
enum class Content : unsigned char {
  anything,
  result,
  list,
  text,
  reply,
  caught,
};
using Contents = std::map<std::string, Content>;

// The fields of a kind of content, and what to write instead of others.
struct Fields {
  Content content;
  const char* what;
  std::vector<std::string> names;
  const char* otherwise; // suggested behind the name
};

// The table of contents with fixed fields.
const Fields& fields_of(Content content) {
  static const Fields table[] = {
      {Content::result,
       "what a query gives",
       {"count", "columns", "rows"},
       ".rows[0].name"},
      {Content::list, "a list", {}, "[0]"},
      {Content::text, "a text", {}, "[0]"},
      {Content::reply, "a reply", {"command", "params"}, ".params[0]"},
      {Content::caught,
       "an error",
       {"kind", "message", "file", "line", "value"},
       ".message"},
  };
  return *std::find_if(
      std::begin(table), std::end(table),
      [content](const Fields& one) { return one.content == content; });
}

// The kind of an expression's value, as far as its form shows.
Content content_of(const Node& node) {
  if (node.kind == NodeKind::list)
    return Content::list;
  if (node.kind == NodeKind::string)
    return Content::text;
  if (node.kind == NodeKind::call) {
    static const std::vector<std::string> lists{
        "split", "sort", "reverse", "range", "keys", "values", "column"};
    if (std::find(lists.begin(), lists.end(), node.text) != lists.end())
      return Content::list;
  }
  return Content::anything;
}

// What a statement puts into the variable that it names.
Content content_of(const Element& element) {
  if (element.is("querydb"))
    return Content::result;
  if (element.is("request"))
    return Content::reply;
  if (element.is("catch"))
    return Content::caught;
  if (element.is("readfile"))
    return Content::text;
  if (element.is("listfiles") || element.is("getlist"))
    return Content::list;
  if (element.is("object"))
    return element.value("class") == "map" ? Content::anything : Content::list;
  if (!element.is("var") && !element.is("const") && !element.is("set"))
    return Content::anything;
  const auto parsed = parse_expression(element.value("expr"));
  return parsed.node ? content_of(*parsed.node) : Content::anything;
}

// A variable that is written with different contents may hold anything.
void note(Contents& contents, const std::string& name, Content content) {
  const auto [known, is_new] = contents.emplace(name, content);
  if (!is_new && known->second != content)
    known->second = Content::anything;
}

// The contents of all variables that statements inside of the element write.
Contents contents_of(const Element& owner, const ElementRule& rule) {
  Contents contents;
  walk(owner, rule, [&](const Element& element, const ElementRule&) {
    for (const auto* attribute : {"name", "return"})
      if (is_identifier(element.value(attribute)))
        note(contents, element.value(attribute), content_of(element));
    for (const auto* attribute : {"each", "index"})
      note(contents, element.value(attribute), Content::anything);
    // A variable that is passed by reference may hold anything afterwards.
    if (element.is("call"))
      for (const auto& argument : element.children)
        note(contents, argument.value("expr"), Content::anything);
  });
  return contents;
}

// Whether the field would be a count in another language.
bool counts(std::string_view field) {
  return field == "length" || field == "size" || field == "count" ||
         field == "len";
}

class FieldLint {
public:
  FieldLint(const Contents& contents, Findings& findings)
      : contents_(contents), findings_(findings) {}

  void look_at(const Node& node, const Source& source) {
    visit_below(node, [&](const Node& one) {
      if (one.kind == NodeKind::field &&
          one.children[0]->kind == NodeKind::name)
        field(one, source);
    });
  }

private:
  void field(const Node& node, const Source& source);

  const Contents& contents_;
  Findings& findings_;
};

// A misspelling, a count, or an example of what can be written.
void FieldLint::field(const Node& node, const Source& source) {
  const auto& variable = node.children[0]->text;
  const auto found = contents_.find(variable);
  if (found == contents_.end() || found->second == Content::anything)
    return;
  const auto& known = fields_of(found->second);
  if (std::find(known.names.begin(), known.names.end(), node.text) !=
      known.names.end())
    return;
  auto hint = did_you_mean(node.text, known.names);
  if (counts(node.text) && known.content != Content::caught)
    hint = "; how many there are is " + (known.content == Content::result
                                             ? variable + ".count"
                                             : "length(" + variable + ")");
  else if (hint.empty())
    hint = "; write for example " + variable + known.otherwise;
  warn(findings_, "unknown-field", source.spot(node.offset, node.text.size()),
       std::string(known.what) + " has no field '" + node.text + "'" + hint);
}

// Each top-level element (a handler, a state, a topic …) is examined by itself;
// session variables are left out, as anything may write them.
void lint_owner(const Element& owner, const ElementRule& rule,
                const std::set<std::string>& session, Findings& findings) {
  auto contents = contents_of(owner, rule);
  for (const auto& name : session)
    contents.erase(name);
  FieldLint lint(contents, findings);
  walk(owner, rule, [&](const Element& element, const ElementRule& its) {
    visit_nodes(element, its, [&](const Node& node, const Source& source) {
      lint.look_at(node, source);
    });
  });
}

} // namespace

void lint_fields(const LintContext& context, Findings& findings) {
  std::set<std::string> session; // anything may write them
  for (const auto& variable : context.program.variables)
    session.insert(variable.name);
  for (const auto& document : context.documents) {
    const auto& rule = rule_of(document.root);
    for (const auto& child : document.root.children)
      if (const auto* inside = find_rule(child.name, rule.holds);
          inside && !document.platform)
        lint_owner(child, *inside, session, findings);
  }
}

} // namespace parlour::script::lint
