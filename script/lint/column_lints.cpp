// changing-values: a script changes a column whose values the understanding
// knows, from a slot or a grammar. After each change it is built anew.
//
//   <slot …><cardinality type="query" source="db:guest.name"/></slot>
//   <querydb param="insert into guest (name) values ({who})"/>
#include <cctype>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "runtime/text/sql_scanner.hpp"
#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

// The words and single characters of a statement, in small letters.
std::vector<std::string> words_of(const std::string& sql) {
  std::vector<std::string> words;
  for (SqlScanner scanner(sql); !scanner.at_end();) {
    const auto token = scanner.next();
    if (token.kind == SqlTokenKind::quoted && token.text.size() > 2 &&
        token.text[0] != '\'')
      words.push_back(sql_lower(token.text.substr(1, token.text.size() - 2)));
    else if (token.kind != SqlTokenKind::blank)
      words.push_back(sql_lower(token.text));
  }
  return words;
}

// What a statement changes: columns of a table, or all of them if none is
// named.
struct Change {
  std::string table;
  std::set<std::string> columns;

  bool changes(const std::string& column) const {
    return columns.empty() || columns.contains(column);
  }
};

// "a" and "b" of "update t set a = 1, b = f(2, 3) where …", from behind "set".
std::set<std::string> set_columns(const std::vector<std::string>& words,
                                  std::size_t at) {
  std::set<std::string> columns;
  int depth = 0;
  for (bool begins = true; at < words.size() && words[at] != "where"; ++at) {
    depth += words[at] == "(" ? 1 : words[at] == ")" ? -1 : 0;
    if (begins)
      columns.insert(words[at]);
    begins = depth == 0 && words[at] == ",";
  }
  return columns;
}

// Nothing if it only reads, or has a form of its own ("insert or replace").
std::optional<Change> change_of(const std::string& sql) {
  const auto words = words_of(sql);
  const auto word = [&](std::size_t at) {
    return at < words.size() ? words[at] : std::string();
  };
  if (word(0) == "update" && word(2) == "set")
    return Change{word(1), set_columns(words, 3)};
  if ((word(0) == "insert" && word(1) == "into") ||
      (word(0) == "delete" && word(1) == "from"))
    return Change{word(2), {}};
  return {};
}

// "@db:guest.name" in the text of a grammar.
void add_columns_of(const std::string& grammar, std::set<std::string>& names) {
  for (auto at = grammar.find("@db:"); at != std::string::npos;
       at = grammar.find("@db:", at + 1)) {
    auto end = at + 4;
    while (end < grammar.size() &&
           (grammar[end] == '.' || grammar[end] == '_' ||
            std::isalnum(static_cast<unsigned char>(grammar[end]))))
      ++end;
    names.insert(grammar.substr(at + 1, end - at - 1));
  }
}

// The names of columns whose values the understanding knows: "db:guest.name".
std::set<std::string> known_columns(const LintContext& context) {
  std::set<std::string> names;
  const auto& model = context.program.understanding;
  if (!model)
    return names;
  for (const auto& topic : model->topics)
    for (const auto& slot : topic.slots)
      if (!slot.source.empty())
        names.insert(slot.source);
  for (const auto& grammar : model->grammars)
    add_columns_of(grammar.text, names);
  return names;
}

// Looks at statements that the application's own database is asked.
class ColumnLint {
public:
  ColumnLint(const LintContext& context, Findings& findings)
      : columns_(known_columns(context)), findings_(findings) {}

  bool has_any() const {
    return !columns_.empty();
  }

  // Notes which database a connection is to.
  void note(const Element& element) {
    if (element.is("connectdb") && !element.value("param").empty())
      others_.insert(element.value("name"));
  }

  void look_at(const Element& element) {
    const auto* sql = element.attribute("param");
    if (!element.is("querydb") || !sql || others_.contains(element.value("db")))
      return;
    const auto change = change_of(sql->value);
    if (!change)
      return;
    for (const auto& name : columns_) {
      const auto point = name.find('.');
      const bool is_own =
          point == name.rfind('.'); // not "db:Archive.robot.name"
      if (is_own && sql_lower(name.substr(3, point - 3)) == change->table &&
          change->changes(sql_lower(name.substr(point + 1))))
        return warn(findings_, "changing-values", sql->value_position,
                    "this changes '" + name +
                        "', whose values a slot or a grammar names: the "
                        "understanding is built anew after each change; take "
                        "them from a view of the rows that stay, or the value "
                        "as text (@words)");
    }
  }

private:
  std::set<std::string> columns_;
  std::set<std::string> others_; // connections, "" for the one without a name
  Findings& findings_;
};

} // namespace

void lint_columns(const LintContext& context, Findings& findings) {
  ColumnLint lint(context, findings);
  if (!lint.has_any())
    return;
  walk_statements(context, false,
                  [&](const Element& element) { lint.note(element); });
  walk_statements(context, false,
                  [&](const Element& element) { lint.look_at(element); });
}

} // namespace parlour::script::lint
