// KnowledgeQuery: from filled slots to a statement with bound values, and from
// an empty answer to the next, relaxed one (engine rule 6). Pure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runtime/base/value.hpp"
#include "script/dialogue/frame/topic_frame.hpp"
#include "script/program/program.hpp"

namespace parlour::dialogue {

// How the column is compared: a <by> without a match of its own has the slot's.
script::Match match_of(const script::Topic& topic, const script::QueryBy& by);

struct Statement {
  std::string kind; // db, facts, aiml, ontology
  std::string name; // which database or fact table; may be empty
  std::string sql;  // for db
  List values;      // bound in order
  Value asked;      // map slot -> value, all that were asked with at first
  std::vector<std::string> relaxed; // slots left out so far, in order
  std::size_t source = 0;           // which of the topic's queries

  template <class Archive>
  void serialize(Archive& archive) {
    archive(kind, name, sql, values, asked, relaxed, source);
  }
};

// Made by Enquiries for one answer; it keeps the frame as it was then, and
// where it is in the queries and their relaxed forms. The program must outlive
// it.
class KnowledgeQuery {
public:
  KnowledgeQuery() = default; // to be read from bytes
  KnowledgeQuery(const script::Topic& topic, FramePointer frame);

  // The first statement, or nothing where the topic has no query. Slots without
  // an accepted value take no part.
  std::optional<Statement> first();
  // After an answer without rows: with the <by> of lowest `relax` left out,
  // then the next one; after those the next source, whole again; else nothing.
  std::optional<Statement> next();

  bool is_of(const script::Topic& topic) const {
    return topic_ == &topic;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.topic(topic_);
    archive(frame_, source_);
    archive.slots_of(frame_ ? frame_->topic : script::no_id, relaxed_);
    archive.check(frame_ && source_ < topic_->queries.size() &&
                      topic_ == &archive.program().topics[frame_->topic],
                  "a query is another topic's");
  }

private:
  // The current source with all conditions but the relaxed ones.
  Statement statement() const;
  SlotId next_relaxed() const; // no_id where nothing is left to relax

  const script::Topic* topic_ = nullptr;
  FramePointer frame_;
  std::size_t source_ = 0;
  std::vector<SlotId> relaxed_;
};

// Runs a statement of kind "facts" against the program's tables: equal
// (spelling case aside), prefix, contains.
ResultSet query_facts(const script::Program& program,
                      const script::Topic& topic, const Statement& statement);

} // namespace parlour::dialogue
