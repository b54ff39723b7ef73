// The part of the topic engine that looks things up and answers (engine rule
// 6; paper IV.B, Fig. 3).
#include <utility>

#include "script/dialogue/agenda/steps.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

namespace {

void tell(Step& step, Expected<Value> outcome) {
  step.kind = StepKind::looked_up;
  step.matter().data = std::move(outcome);
}

} // namespace

void TopicEngine::look_up(Step& step) {
  auto& matter = step.matter();
  if (!matter.query) {
    auto frame = std::make_shared<const Frame>(context_.frame(step.topic));
    matter.query.emplace(context_.topic(step.topic), std::move(frame));
    matter.statement = matter.query->first();
    if (!matter.statement) {
      answer_enquiry(step);
      return;
    }
  }
  const auto& statement = *matter.statement;
  if (statement.kind == "facts") {
    look_up_facts(step);
    return;
  }
  if (statement.kind != "db") {
    refuse_source(step);
    return;
  }
  QueryRequest request;
  request.id = context_.next_id();
  request.database = statement.name;
  request.sql = statement.sql;
  request.values = statement.values;
  context_.lane.wait(request.id, Lane::Others::are_held);
  query_ = {request.id, std::move(step)};
  context_.port.query(std::move(request));
}

void TopicEngine::look_up_facts(Step& step) {
  tell(step, Value(query_facts(*context_.program, context_.topic(step.topic),
                               *step.more->statement)));
  context_.lane.at_once(std::move(step));
}

// A kind of knowledge that this build does not have.
void TopicEngine::refuse_source(Step& step) {
  const auto& source =
      context_.topic(step.topic).queries[step.more->statement->source];
  tell(step, fail(ErrorKind::refused,
                  "<query source=\"" + source.kind +
                      "\"> is not available yet; use a database or <facts>",
                  context_.program->place(source.position)));
  context_.lane.at_once(std::move(step));
}

bool TopicEngine::query_answered(QueryId id, Expected<ResultSet>& outcome) {
  if (!query_ || query_->id != id)
    return false;
  auto step = std::move(query_->step);
  query_.reset();
  tell(step, std::move(outcome).map([](ResultSet set) { return Value(set); }));
  context_.lane.wake(id, std::move(step));
  return true;
}

void TopicEngine::looked_up(Step& step) {
  auto& matter = step.matter();
  const auto& rows = *matter.data;
  if (!rows) {
    context_.inspect(InspectionKind::error, context_.topic(step.topic).name,
                     to_string(rows.error()));
    if (context_.apologies.due(context_.now))
      say("unavailable", step.topic, script::no_id,
          Map{{"reason", rows.error().message}}, step.turn);
    rest(step.topic);
    return;
  }
  if (!*rows) // no row: the next statement, if there is one
    if (auto statement = matter.query->next()) {
      matter.statement = std::move(statement);
      step.kind = StepKind::look_up;
      context_.lane.at_once(std::move(step));
      return;
    }
  FrameChange change_to;
  change_to.kind = FrameChange::Kind::answered;
  change_to.value = *rows;
  change_to.asked = matter.statement->asked;
  change_to.relaxed = matter.statement->relaxed;
  change(step.topic, std::move(change_to));
  const auto& relaxed = matter.statement->relaxed;
  context_.raise(
      "Knowledge", "Result",
      {*rows, matter.statement->asked, List(relaxed.begin(), relaxed.end())},
      step.turn);
  answer_enquiry(step);
}

// The topic's <filled> has run. If it said nothing, the engine answers; then
// the enquiry rests (engine rule 5).
void TopicEngine::answer(Step& step) {
  const auto& frame = context_.frame(step.topic);
  const bool refused = !take_refusals(step.topic).empty();
  const bool silent = output_.told() == step.mark;
  if (silent && refused)
    say("acknowledge", step.topic, script::no_id, {}, step.turn);
  else if (silent)
    say("answer", step.topic, script::no_id,
        Map{{"rows", frame.rows},
            {"asked", frame.asked},
            {"relaxed", List(frame.relaxed.begin(), frame.relaxed.end())}},
        step.turn);
  rest(step.topic);
  if (auto next = needed_by(step.topic); next != script::no_id)
    context_.lane.at_once(topic_step(StepKind::activate, next));
}

void TopicEngine::rest(TopicId topic) {
  set_status(topic, TopicStatus::resting);
  context_.order.rests(topic, context_.now);
  if (asked_ && asked_->topic == topic)
    asked_.reset();
}

} // namespace parlour::dialogue
