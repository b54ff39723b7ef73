// Compiles such elements:
//
//   <query source="facts:Shops" order="level, name">
//     <by slot="Product" column="sells" match="contains"/>
//     <by slot="Level" relax="1"/>
//   </query>
//   <facts name="Shops"><fact name="…" sells="…" level="…"/></facts>
//
// All names are resolved here: the table, its columns and the slots.

#include "script/compiler/knowledge_compiler.hpp"

#include <algorithm>

#include "runtime/text/sql_check.hpp"
#include "script/compiler/slot_compiler.hpp"
#include "script/xml/attribute_check.hpp"
#include "script/xml/element_table.hpp"

namespace parlour::script {

namespace {

const std::vector<std::string> source_kinds{"db", "facts", "aiml", "ontology"};

// Compiles one <query>.
class QueryCompiler {
public:
  QueryCompiler(const Element& element, const Topic& topic,
                Compilation& compilation)
      : element_(element), topic_(topic), compilation_(compilation) {}

  KnowledgeSource compile();

private:
  void read_source();
  void check_statement();
  void check_facts();
  void find_facts();
  std::uint32_t table_of(TopicId topic) const;
  void report_no_facts(TopicId own);
  void check_column(const std::string& name, Position position);
  void check_order();
  void add_by(const Element& by);
  std::string column_of(const Element& by);
  void error(Position position, std::string message) {
    compilation_.findings.error(position, std::move(message));
  }

  const Element& element_;
  const Topic& topic_;
  Compilation& compilation_;
  KnowledgeSource source_;
};

// `source` is a kind, optionally with a name: "db", "facts:Shops".
void QueryCompiler::read_source() {
  const auto& attribute = *element_.attribute("source");
  const auto colon =
      std::min(attribute.value.find(':'), attribute.value.size());
  source_.kind = attribute.value.substr(0, colon);
  if (colon < attribute.value.size())
    source_.name = attribute.value.substr(colon + 1);
  const auto& kinds = source_kinds;
  if (std::find(kinds.begin(), kinds.end(), source_.kind) == kinds.end())
    error(attribute.value_position, "there is no knowledge of the kind '" +
                                        source_.kind + "'; expected " +
                                        alternatives(kinds) +
                                        did_you_mean(source_.kind, kinds));
  else if (source_.kind == "aiml" || source_.kind == "ontology")
    error(attribute.value_position,
          "queries of the kind '" + source_.kind + "' are not available yet");
}

// A query of a database needs one select statement, which the database itself
// checks later (`parlour check` asks it).
void QueryCompiler::check_statement() {
  const auto* statement = element_.attribute("param");
  if (!statement)
    return error(element_.position,
                 "<query source=\"db\"> needs the attribute 'param': one "
                 "select statement");
  source_.statement = statement->value;
  auto wrong = wrong_select(statement->value);
  if (!wrong.empty())
    error(statement->value_position, std::move(wrong));
}

// The table with the name of this query among the facts of `topic` (no_id: of
// all topics). Without a name it is the only table there.
std::uint32_t QueryCompiler::table_of(TopicId topic) const {
  const auto& tables = compilation_.program.facts;
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < tables.size(); ++i)
    if (tables[i].topic == topic)
      all.push_back(i);
  for (const auto i : all)
    if (tables[i].name == source_.name)
      return i;
  return source_.name.empty() && all.size() == 1 ? all.front() : no_id;
}

// The topic's own tables hide the others, so a query without a name does not
// look further if the topic has any.
void QueryCompiler::find_facts() {
  const auto& tables = compilation_.program.facts;
  const auto own = compilation_.program.topic(topic_.name);
  // The topic's tables first, then those of all topics.
  const bool has_own = std::ranges::count(tables, own, &FactTable::topic) != 0;
  source_.facts = table_of(own);
  if (source_.facts == no_id && !(has_own && source_.name.empty()))
    source_.facts = table_of(no_id);
  if (source_.facts == no_id)
    return report_no_facts(own);
  source_.name = tables[source_.facts].name;
}

void QueryCompiler::report_no_facts(TopicId own) {
  std::vector<std::string> names;
  for (const auto& table : compilation_.program.facts)
    if (table.topic == own || table.topic == no_id)
      names.push_back(table.name);
  error(element_.attribute("source")->value_position,
        source_.name.empty() ? "which <facts>? expected facts:name"
                             : "there are no <facts> named '" + source_.name +
                                   "'" + did_you_mean(source_.name, names));
}

// Facts have no SQL, so `param` would do nothing.
void QueryCompiler::check_facts() {
  if (const auto* statement = element_.attribute("param"))
    error(statement->position, "'param' is of <query source=\"db\">; <facts> "
                               "are narrowed by <by>");
  find_facts();
}

// A column must occur in some <fact>. The columns of a database are known to it
// alone, so its own errors report them.
void QueryCompiler::check_column(const std::string& name, Position position) {
  if (source_.facts == no_id)
    return;
  const auto& rows = compilation_.program.facts[source_.facts].rows;
  if (rows.row_count() == 0 || rows.cell(0, name))
    return;
  const std::vector<std::string> known(rows.columns.begin(),
                                       rows.columns.end());
  error(position, "no <fact> of these has '" + name + "'" +
                      (did_you_mean(name, known).empty()
                           ? "; they have " + alternatives(known)
                           : did_you_mean(name, known)));
}

// The columns to sort by must exist.
void QueryCompiler::check_order() {
  const auto* order = element_.attribute("order");
  if (!order || order->value.empty())
    return;
  source_.order = order->value;
  const auto columns = sort_columns(order->value);
  if (columns.empty())
    error(order->value_position, "'" + order->value +
                                     "' is no order; expected "
                                     "columns such as \"level desc, name\"");
  for (const auto& column : columns)
    check_column(column.name, order->value_position);
}

// The column is named as the slot if nothing else is said.
std::string QueryCompiler::column_of(const Element& by) {
  const auto* column = by.attribute("column");
  const auto& name = column ? *column : *by.attribute("slot");
  if (!is_sql_name(name.value))
    error(name.value_position, "'" + name.value + "' is not a column's name");
  else
    check_column(name.value, name.value_position);
  return name.value;
}

// A <by> refers to a slot of the topic and a column of the source.
void QueryCompiler::add_by(const Element& by) {
  const auto& slot = *by.attribute("slot");
  QueryBy result;
  result.slot = topic_.slot(slot.value);
  if (result.slot == no_id) {
    const auto known = names_of(topic_.slots);
    return error(slot.value_position, "topic '" + topic_.name +
                                          "' has no slot '" + slot.value + "'" +
                                          did_you_mean(slot.value, known));
  }
  result.column = column_of(by);
  result.match = match_of(by);
  result.relax =
      static_cast<std::uint32_t>(parse_count(by.value("relax")).value_or(0));
  source_.by.push_back(std::move(result));
}

// Each step reports its own mistakes; the result is complete if there are none.
KnowledgeSource QueryCompiler::compile() {
  source_.position = element_.position;
  read_source();
  if (source_.kind == "db")
    check_statement();
  else if (source_.kind == "facts")
    check_facts();
  check_order();
  for (const auto& by : element_.children)
    add_by(by);
  return std::move(source_);
}

} // namespace

void compile_query(const Element& element, Topic& topic,
                   Compilation& compilation) {
  topic.queries.push_back(QueryCompiler(element, topic, compilation).compile());
}

// The columns of a table are all attributes that any <fact> has; a fact without
// one of them has an unknown cell.
void compile_facts(const Element& element, TopicId topic,
                   Compilation& compilation) {
  FactTable table;
  table.name = element.value("name");
  table.topic = topic;
  for (const auto& other : compilation.program.facts)
    if (other.name == table.name && other.topic == topic)
      compilation.findings.error(element.position, "there are <facts> named '" +
                                                       table.name +
                                                       "' already");
  std::vector<std::string> columns;
  for (const auto& fact : element.children)
    for (const auto& attribute : fact.attributes)
      if (std::find(columns.begin(), columns.end(), attribute.name) ==
          columns.end())
        columns.push_back(attribute.name);
  for (const auto& fact : element.children)
    for (const auto& column : columns) {
      const auto* attribute = fact.attribute(column);
      table.rows.cells.push_back(attribute ? Value(attribute->value) : Value());
    }
  table.rows.columns = std::move(columns);
  compilation.program.facts.push_back(std::move(table));
}

} // namespace parlour::script
