// missing-partner: a statement needs another one that is nowhere in the
// application: a <pop> needs a <push>, a <cancel timer> its <timer>, and a
// query that writes a connection that may write.
//
//   <cancel timer="tee"/>                 no <timer> has this name
//   <querydb param="insert into …"/>      no connection with write="true"
#include <algorithm>
#include <array>
#include <cctype>

#include "runtime/message/roles.hpp"
#include "script/lint/passes.hpp"
#include "script/xml/attribute_check.hpp"

namespace parlour::script::lint {

namespace {

// The names that statements give to something; `any` if one is computed.
struct Given {
  std::set<std::string> names;
  bool any = false;

  void add(const std::string& name) {
    any |= is_computed(name);
    names.insert(name);
  }
  // Whether certainly nothing has this name.
  bool lacks(const std::string& name) const {
    return !any && !is_computed(name) && names.count(name) == 0;
  }
  std::vector<std::string> all() const {
    return {names.begin(), names.end()};
  }
};

// Ignores case, and blanks and brackets before the word.
bool begins_with_word(std::string_view text, std::string_view word) {
  const auto first = text.find_first_not_of(" \t\r\n(");
  if (first == std::string_view::npos)
    return false;
  text.remove_prefix(first);
  return text.size() > word.size() &&
         std::equal(word.begin(), word.end(), text.begin(),
                    [](char small, char c) {
                      return small ==
                             std::tolower(static_cast<unsigned char>(c));
                    }) &&
         std::isspace(static_cast<unsigned char>(text[word.size()])) != 0;
}

// Whether a literal SQL statement changes data.
bool writes(const std::string& sql) {
  constexpr std::array words{"insert", "update", "delete", "replace",
                             "create", "drop",   "alter"};
  return std::ranges::any_of(
      words, [&](const char* word) { return begins_with_word(sql, word); });
}

// note() collects over the whole application first; look_at() then reports.
class PartnerLint {
public:
  PartnerLint(const LintContext& context, Findings& findings)
      : findings_(findings), variables_(declared_names(context)) {
    for (const auto& [component, roles] : context.options.component_roles)
      if (std::ranges::any_of(roles, [](const auto& role) {
            return canonical_role(role) == "Database";
          }))
        databases_.add(component);
  }

  void note(const Element& element);
  void look_at(const Element& element);

private:
  void look_at_query(const Element& element);
  void look_at_connection(const Element& element);
  bool is_no_database(const std::string& name) const;
  void look_at_name(const Element& element, const char* attribute,
                    const Given& known, const std::string& what);
  void missing(const Attribute& name, const std::string& what,
               const std::vector<std::string>& known);

  Findings& findings_;
  std::set<std::string> variables_;
  Given timers_, sockets_, connections_, writable_, databases_;
  bool pushes_ = false;
};

// Collects what statements open, start or connect.
void PartnerLint::note(const Element& element) {
  pushes_ |= element.is("push");
  if (element.is("timer"))
    timers_.add(element.value("name"));
  if (element.is("socket"))
    sockets_.add(element.value("name"));
  if (!element.is("connectdb"))
    return;
  connections_.add(element.value("name"));
  if (element.value("write") == "true")
    writable_.add(element.value("name"));
}

void PartnerLint::missing(const Attribute& name, const std::string& what,
                          const std::vector<std::string>& known) {
  warn(findings_, "missing-partner", name.value_position,
       what + " is called '" + name.value + "'" +
           did_you_mean(name.value, known));
}

// Reports a name that no statement gives.
void PartnerLint::look_at_name(const Element& element, const char* attribute,
                               const Given& known, const std::string& what) {
  const auto* name = element.attribute(attribute);
  if (name && known.lacks(name->value))
    missing(*name, what, known.all());
}

// Without known components nothing is certain.
bool PartnerLint::is_no_database(const std::string& name) const {
  return !databases_.names.empty() && databases_.lacks(name) &&
         !find_role(name);
}

// <connectdb param="Name">: a database of that name must exist. The parameter
// is a name only if no variable is called so.
void PartnerLint::look_at_connection(const Element& element) {
  const auto* database = element.attribute("param");
  if (database && is_identifier(database->value) &&
      variables_.count(database->value) == 0 && is_no_database(database->value))
    missing(*database, "no database", databases_.all());
}

// The connection must exist, and for a statement that writes be opened for it
// (language rule 11.12).
void PartnerLint::look_at_query(const Element& element) {
  const auto* db = element.attribute("db");
  if (db && connections_.lacks(db->value) && is_no_database(db->value)) {
    auto known = connections_.all();
    const auto more = databases_.all();
    known.insert(known.end(), more.begin(), more.end());
    return missing(*db, "no <connectdb> and no database", known);
  }
  const auto connection = db ? db->value : std::string();
  if (!element.is("querydb") || !writes(element.value("param")) ||
      !writable_.lacks(connection))
    return;
  const auto name = db ? "name=\"" + connection + "\" " : std::string();
  warn(
      findings_, "missing-partner", element.attribute("param")->value_position,
      "this writes, and nothing opens the database to be written: <connectdb " +
          name + "param=\"\" write=\"true\"/> before it does");
}

// Which statements need which partner.
void PartnerLint::look_at(const Element& element) {
  if (element.is("pop") && !pushes_)
    warn(findings_, "missing-partner", element.position,
         "no <push> enters a state as a subtask, and <pop> comes back from "
         "one only; a <transit> goes to another state");
  else if (element.is("cancel"))
    look_at_name(element, "timer", timers_, "no <timer>");
  else if (element.is("sendsocket") || element.is("closesocket"))
    look_at_name(element, "name", sockets_, "no <socket>");
  else if (element.is("connectdb"))
    look_at_connection(element);
  else if (element.is("querydb") || element.is("transaction"))
    look_at_query(element);
}

} // namespace

void lint_partners(const LintContext& context, Findings& findings) {
  if (!context.settings)
    return;
  PartnerLint lint(context, findings);
  walk_statements(context, true,
                  [&](const Element& element) { lint.note(element); });
  walk_statements(context, false,
                  [&](const Element& element) { lint.look_at(element); });
}

} // namespace parlour::script::lint
