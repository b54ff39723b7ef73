#include "script/dialogue/topic_engine/course/enquiries.hpp"

#include <memory>
#include <utility>

#include "script/dialogue/knowledge/knowledge_query.hpp"
#include "script/dialogue/questions/bodies.hpp"

namespace parlour::dialogue {

namespace {

steps::LookedUp looked_up(steps::LookUp& step, Expected<Value> rows) {
  step.lookup->rows = std::move(rows);
  return {step.topic, step.turn, std::move(step.lookup)};
}

} // namespace

// The frame is copied, so that relaxed statements ask with the values that the
// first one had. Facts are answered at once, everything else by the port.
void Enquiries::take(steps::LookUp&& step) {
  if (!step.lookup) {
    auto frame = std::make_shared<const TopicFrame>(frames_[step.topic]);
    KnowledgeQuery query(context_.topic(step.topic), std::move(frame));
    auto statement = query.first();
    if (!statement) {
      answer_enquiry(step.topic, step.turn);
      return;
    }
    step.lookup = std::make_shared<Lookup>(
        Lookup{std::move(query), std::move(*statement)});
  }
  const auto& statement = step.lookup->statement;
  if (statement.kind == "facts") {
    look_up_facts(step);
    return;
  }
  if (statement.kind != "db") {
    refuse_source(step);
    return;
  }
  const auto id = context_.next_id();
  context_.lane.wait(id, Lane::Others::are_held);
  query_ = {id, std::move(step)};
  resume();
}

// The first asking goes the same way as one after a restart, so both ask the
// same.
void Enquiries::resume() const {
  if (!query_)
    return;
  const auto& statement = query_->step.lookup->statement;
  QueryRequest request;
  request.id = query_->id;
  request.database = statement.name;
  request.sql = statement.sql;
  request.values = statement.values;
  context_.port.query(std::move(request));
}

// Rows, what was asked and what was relaxed go into the frame before the event
// is raised, so that its reactions and <filled> read the same. A source that
// fails ends the enquiry at once: no further query is tried.
void Enquiries::take(steps::LookedUp&& step) {
  auto& lookup = *step.lookup;
  const auto& rows = lookup.rows;
  if (!rows) {
    context_.inspect(InspectionKind::error, context_.topic(step.topic).name,
                     to_string(rows.error()));
    if (output_.may_apologise())
      words_.say("unavailable", step.topic, script::no_id,
                 Map{{"reason", rows.error().message}}, step.turn);
    topic_changes_.answered(step.topic);
    return;
  }
  if (!*rows) // no row: the next statement, if there is one
    if (auto next = lookup.query.next()) {
      lookup.statement = std::move(*next);
      context_.lane.at_once(
          steps::LookUp{step.topic, step.turn, std::move(step.lookup)});
      return;
    }
  const auto& statement = lookup.statement;
  FrameChange change_to;
  change_to.kind = FrameChange::Kind::answered;
  change_to.value = *rows;
  change_to.asked = statement.asked;
  change_to.relaxed = statement.relaxed;
  frames_.change(step.topic, std::move(change_to));
  const auto& relaxed = statement.relaxed;
  messenger_.raise(
      "Knowledge", "Result",
      {*rows, statement.asked, List(relaxed.begin(), relaxed.end())},
      step.turn);
  answer_enquiry(step.topic, step.turn);
}

// The topic's <filled> has run. If it said nothing, the engine answers; then
// the enquiry rests (engine rule 5).
void Enquiries::take(const steps::Answer& step) {
  const auto& frame = frames_[step.topic];
  const bool refused = !refusals_.take_refusals(step.topic).empty();
  const bool silent = output_.told() == step.told;
  if (silent && refused)
    words_.say("acknowledge", step.topic, script::no_id, {}, step.turn);
  else if (silent)
    words_.say(
        "answer", step.topic, script::no_id,
        Map{{"rows", frame.rows},
            {"asked", frame.asked},
            {"relaxed", List(frame.relaxed.begin(), frame.relaxed.end())}},
        step.turn);
  topic_changes_.answered(step.topic);
  if (auto next = topic_changes_.needed_by(step.topic); next != script::no_id)
    context_.lane.at_once(steps::Activate{next});
}

void Enquiries::answer_enquiry(TopicId topic, TurnId turn) {
  StepList steps;
  run_body(context_.topic(topic).filled, topic, script::no_id, turn, steps);
  steps.add(steps::Answer{topic, turn, output_.told()});
  context_.lane.now(std::move(steps));
}

bool Enquiries::query_answered(QueryId id, Expected<Value>& outcome) {
  if (!query_ || query_->id != id)
    return false;
  auto step = std::move(query_->step);
  query_.reset();
  context_.lane.wake(id, looked_up(step, std::move(outcome)));
  return true;
}

void Enquiries::look_up_facts(steps::LookUp& step) {
  auto rows = query_facts(*context_.program, context_.topic(step.topic),
                          step.lookup->statement);
  context_.lane.at_once(looked_up(step, Value(std::move(rows))));
}

// A kind of knowledge that this build does not have.
void Enquiries::refuse_source(steps::LookUp& step) {
  const auto& source =
      context_.topic(step.topic).queries[step.lookup->statement.source];
  context_.lane.at_once(looked_up(
      step, fail(ErrorKind::refused,
                 "<query source=\"" + source.kind +
                     "\"> is not available yet; use a database or <facts>",
                 context_.program->place(source.position))));
}

} // namespace parlour::dialogue
