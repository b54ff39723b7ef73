// Queries (language rules 11.1 and 11.2).
#include "script/compiler/code/statements/query_statements.hpp"

#include <array>
#include <cctype>
#include <map>

#include "runtime/text/sql_scanner.hpp"

namespace parlour::script {

namespace {

// Functions that read the database's own clock or random numbers. A
// conversation with them could not be replayed with the same result.
constexpr std::array<std::string_view, 22> impure{
    "now(",           "current_timestamp",
    "current_date",   "current_time",
    "curdate(",       "curtime(",
    "sysdate(",       "rand(",
    "random(",        "randomblob(",
    "utc_timestamp",  "utc_date",
    "utc_time",       "localtime(",
    "localtimestamp", "unix_timestamp()",
    "uuid(",          "date()",
    "time()",         "datetime()",
    "julianday()",    "unixepoch()"};

std::string_view impure_function(const std::string& sql) {
  std::string lower;
  for (const char c : sql)
    lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (auto name : impure)
    for (auto at = lower.find(name); at != std::string::npos;
         at = lower.find(name, at + 1))
      if (at == 0 || !std::isalnum(static_cast<unsigned char>(lower[at - 1])))
        return name;
  return lower.find("'now'") != std::string::npos ? "'now'"
                                                  : std::string_view();
}

// Whether the text of a statement is built with '+'.
bool joins(const Node& node) {
  if (node.kind == NodeKind::binary && node.operation == Operator::add)
    return true;
  if (node.kind == NodeKind::choice)
    return joins(*node.children[1]) || joins(*node.children[2]);
  return false;
}

bool is_plain_literal(const Node& node) {
  return node.kind == NodeKind::string;
}

} // namespace

void QueryStatements::joined_sql(const Node& node, const Source& source) {
  if (!joins(node) || b_.program.settings.unsafe_sql)
    return;
  b_.findings.add(
      {b_.program.single_file ? Severity::warning : Severity::error,
       source.spot(node.offset, 1),
       "SQL must not be built with '+': write {expr} in the text, or ? and "
       "args, so that values are bound",
       "joined-sql"});
}

void QueryStatements::impure_sql(std::string_view name, const Source& source) {
  b_.findings.add({Severity::warning, source.spot(),
                   "the database's own " + std::string(name) +
                       " cannot be repeated; pass now()",
                   "impure-sql"});
}

// Each {expr} and each `?` becomes a bound value, in the order of the text
// (language rule 11.1). A placeholder in quotes or in a comment would be a
// plain question mark, so the text is read as the database reads it.
void QueryStatements::bound_sql(const Source& source,
                                std::vector<NodePointer> arguments,
                                const Source& arguments_source, Register target,
                                Register values) {
  std::string sql;
  std::map<std::size_t, TextPart> embedded; // by its place
  for (auto& part : expressions_.split_text(source))
    if (part.node) {
      const auto at = sql.size();
      sql += '?';
      embedded.emplace(at, std::move(part));
    } else {
      sql += part.literal;
    }
  std::vector<std::pair<NodePointer, Source>> bound;
  std::size_t used = 0;
  for (SqlScanner scanner(sql); !scanner.at_end();) {
    const auto token = scanner.next();
    if (token.kind != SqlTokenKind::placeholder || token.text.front() != '?')
      continue;
    const auto at = static_cast<std::size_t>(token.text.data() - sql.data());
    if (auto part = embedded.extract(at); !part.empty())
      bound.emplace_back(std::move(part.mapped().node), part.mapped().source);
    else if (used++ < arguments.size())
      bound.emplace_back(std::move(arguments[used - 1]), arguments_source);
  }
  for (const auto& [at, part] : embedded)
    b_.findings.add({Severity::error, part.source.spot(),
                     "{…} is a bound value; leave out the quotes or the "
                     "comment around it",
                     "expression"});
  if (used != arguments.size())
    error(source.start, "the statement has " + std::to_string(used) +
                            " placeholders '?', but args has " +
                            std::to_string(arguments.size()) +
                            (arguments.size() == 1 ? " value" : " values"));
  const auto name = impure_function(sql);
  if (!name.empty())
    impure_sql(name, source);
  b_.load_text(target, sql);
  const auto base = b_.allocate(bound.size());
  for (std::size_t i = 0; i < bound.size(); ++i)
    expressions_.into(*bound[i].first, bound[i].second,
                      static_cast<Register>(base + i));
  b_.emit(Operation::new_list, values, base, bound.size());
  b_.release(base);
}

// A statement that is an expression, such as a variable, is taken as it is; a
// text has its values bound.
void QueryStatements::sql(const Attribute& attribute, const Attribute* args,
                          Register target, Register values) {
  const auto source = source_of(attribute);
  const Source arguments_source = args ? source_of(*args) : Source{};
  auto parsed = parse_arguments(args ? args->value : "");
  if (!parsed.node)
    expressions_.report(arguments_source, parsed);
  const auto node = expressions_.decide(source);
  if (!node) {
    auto arguments = parsed.node ? std::move(parsed.node->children)
                                 : std::vector<NodePointer>();
    return bound_sql(source, std::move(arguments), arguments_source, target,
                     values);
  }
  joined_sql(*node, source);
  if (is_plain_literal(*node))
    if (const auto name = impure_function(node->text); !name.empty())
      impure_sql(name, source);
  expressions_.into(*node, source, target);
  if (parsed.node)
    expressions_.into(*parsed.node, arguments_source, values);
}

// Three operands: the statement, its values, and the name of the connection.
void QueryStatements::query(const Element& element) {
  const auto base = b_.allocate(3);
  if (const auto* statement = required(element, "param"))
    sql(*statement, element.attribute("args"), base,
        static_cast<Register>(base + 1));
  operand(element, "db", OperandForm::text, static_cast<Register>(base + 2));
  b_.at(element.position);
  perform(EffectKind::querydb, base, base, 3);
  store_result(element.attribute("return"), base);
}

} // namespace parlour::script
