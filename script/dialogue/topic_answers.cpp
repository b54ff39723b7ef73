// The part of the topic engine that looks things up and answers (engine rule
// 6; paper IV.B, Fig. 3).
#include <utility>

#include "script/dialogue/core.hpp"
#include "script/dialogue/steps.hpp"

namespace parlour::dialogue {

namespace {

void tell(Step& step, Expected<Value> outcome) {
  step.kind = StepKind::looked_up;
  step.data = std::make_shared<const Expected<Value>>(std::move(outcome));
}

} // namespace

void TopicEngine::look_up(Step& step) {
  if (!step.query) {
    auto frame = std::make_shared<const Frame>(core_.frame(step.topic));
    step.query = std::make_shared<KnowledgeQuery>(core_.topic(step.topic),
                                                  std::move(frame));
    auto statement = step.query->first();
    if (!statement) {
      answer_enquiry(step);
      return;
    }
    step.statement = std::make_shared<const Statement>(std::move(*statement));
  }
  if (step.statement->kind == "facts") {
    look_up_facts(step);
    return;
  }
  if (step.statement->kind != "db") {
    refuse_source(step);
    return;
  }
  QueryRequest request;
  request.id = core_.next_id();
  request.database = step.statement->name;
  request.sql = step.statement->sql;
  request.values = step.statement->values;
  core_.lane.wait(request.id, false);
  query_ = {request.id, std::move(step)};
  core_.port.query(std::move(request));
}

void TopicEngine::look_up_facts(Step& step) {
  auto rows = query_facts(*core_.program, core_.topic(step.topic),
                          core_.frame(step.topic), *step.statement);
  tell(step, std::move(rows).map([](ResultSet set) { return Value(set); }));
  core_.lane.at_once(std::move(step));
}

// A kind of knowledge that this build does not have.
void TopicEngine::refuse_source(Step& step) {
  const auto& source = core_.topic(step.topic).queries[step.statement->source];
  tell(step, fail(ErrorKind::refused,
                  "<query source=\"" + source.kind +
                      "\"> is not available yet; use a database or <facts>",
                  core_.program->place(source.position)));
  core_.lane.at_once(std::move(step));
}

bool TopicEngine::query_answered(QueryId id, Expected<ResultSet>& outcome) {
  if (!query_ || query_->id != id)
    return false;
  auto step = std::move(query_->step);
  query_.reset();
  tell(step, std::move(outcome).map([](ResultSet set) { return Value(set); }));
  core_.lane.wake(id, std::move(step));
  return true;
}

void TopicEngine::looked_up(Step& step) {
  const auto& rows = *step.data;
  if (!rows) {
    core_.inspect(InspectionKind::error, core_.topic(step.topic).name,
                  to_string(rows.error()));
    say("unavailable", step.topic, script::no_id,
        Map{{"reason", rows.error().message}}, step.turn);
    rest(step.topic);
    return;
  }
  if (!*rows) // no row: the next statement, if there is one
    if (auto statement = step.query->next()) {
      step.statement = std::make_shared<const Statement>(std::move(*statement));
      step.kind = StepKind::look_up;
      core_.lane.at_once(std::move(step));
      return;
    }
  FrameChange change_to;
  change_to.kind = FrameChange::Kind::answered;
  change_to.value = *rows;
  change_to.asked = step.statement->asked;
  change_to.relaxed = step.statement->relaxed;
  change(step.topic, std::move(change_to));
  const auto& relaxed = step.statement->relaxed;
  core_.raise(
      "Knowledge", "Result",
      {*rows, step.statement->asked, List(relaxed.begin(), relaxed.end())},
      step.turn);
  answer_enquiry(step);
}

// The topic's <filled> has run. If it said nothing, the engine answers; then
// the enquiry rests (engine rule 5).
void TopicEngine::answer(Step& step) {
  const auto& frame = core_.frame(step.topic);
  if (core_.mouth.spoken() == step.mark)
    say("answer", step.topic, script::no_id,
        Map{{"rows", frame.rows},
            {"asked", frame.asked},
            {"relaxed", List(frame.relaxed.begin(), frame.relaxed.end())}},
        step.turn);
  rest(step.topic);
  if (auto next = needed_by(step.topic); next != script::no_id)
    core_.lane.at_once(topic_step(StepKind::activate, next));
}

void TopicEngine::rest(TopicId topic) {
  set_status(topic, TopicStatus::resting);
  core_.order.rests(topic, core_.now);
  if (asked_ && asked_->topic == topic)
    asked_.reset();
}

} // namespace parlour::dialogue
