#include "script/dialogue/knowledge/knowledge_query.hpp"

#include <algorithm>
#include <utility>

#include "script/dialogue/knowledge/sql_text.hpp"

namespace parlour::dialogue {

namespace {

using script::Match;
using script::QueryBy;

bool has(const std::vector<SlotId>& slots, SlotId slot) {
  return std::find(slots.begin(), slots.end(), slot) != slots.end();
}

bool is_filled(const TopicFrame& frame, SlotId slot) {
  return slot < frame.slots.size() &&
         frame.slots[slot].status == SlotStatus::filled;
}

// Text is compared without regard to case in every database, so both sides are
// made lower case. Values are bound, never pasted in (engine rule 6.2); a
// pattern of `like` as well, with its own signs escaped.
std::string condition(const QueryBy& by, Match match, const Value& value,
                      List& values) {
  if (match == Match::equal && !value.if_string()) {
    values.push_back(value);
    return by.column + " = ?";
  }
  if (match == Match::equal) {
    values.push_back(value);
    return "lower(" + by.column + ") = lower(?)";
  }
  values.emplace_back((match == Match::contains ? "%" : "") +
                      escape_like(value.text()) + "%");
  return "lower(" + by.column + ") like lower(?) escape '!'";
}

} // namespace

Match match_of(const script::Topic& topic, const QueryBy& by) {
  return by.match == Match::equal ? topic.slots[by.slot].match : by.match;
}

KnowledgeQuery::KnowledgeQuery(const script::Topic& topic, FramePointer frame)
    : topic_(&topic), frame_(std::move(frame)) {}

std::optional<Statement> KnowledgeQuery::first() {
  source_ = 0;
  relaxed_.clear();
  if (topic_->queries.empty())
    return std::nullopt;
  return statement();
}

std::optional<Statement> KnowledgeQuery::next() {
  if (source_ >= topic_->queries.size())
    return std::nullopt;
  if (auto slot = next_relaxed(); slot != script::no_id) {
    relaxed_.push_back(slot);
    return statement();
  }
  relaxed_.clear();
  if (++source_ == topic_->queries.size())
    return std::nullopt;
  return statement();
}

SlotId KnowledgeQuery::next_relaxed() const {
  const QueryBy* lowest = nullptr;
  for (const auto& by : topic_->queries[source_].by)
    if (by.relax > 0 && is_filled(*frame_, by.slot) &&
        !has(relaxed_, by.slot) && (!lowest || by.relax < lowest->relax))
      lowest = &by;
  return lowest ? lowest->slot : script::no_id;
}

// `asked` has the relaxed slots too: the answer may say what was asked for and
// not found. Facts need no text; query_facts() reads `asked` and `relaxed`.
Statement KnowledgeQuery::statement() const {
  const auto& source = topic_->queries[source_];
  Statement statement;
  statement.kind = source.kind;
  statement.name = source.name;
  statement.source = source_;
  for (auto slot : relaxed_)
    statement.relaxed.push_back(topic_->slots[slot].name);
  Map asked;
  std::string conditions;
  for (const auto& by : source.by) {
    if (!is_filled(*frame_, by.slot))
      continue;
    const auto& value = frame_->slots[by.slot].value;
    asked.set(topic_->slots[by.slot].name, value);
    if (has(relaxed_, by.slot))
      continue;
    conditions += conditions.empty() ? "" : " and ";
    conditions += condition(by, match_of(*topic_, by), value, statement.values);
  }
  statement.asked = std::move(asked);
  if (source.kind == "db")
    statement.sql = with_condition(source.statement, conditions, source.order);
  else
    statement.values.clear();
  return statement;
}

} // namespace parlour::dialogue
