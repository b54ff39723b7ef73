#include "tools/parlour/conversation_test/conversation_runner.hpp"

#include <chrono>
#include <deque>
#include <utility>

#include "tools/parlour/application/data_folder.hpp"
#include "tools/parlour/application/node_options.hpp"
#include "tools/parlour/application/plugins/module_names.hpp"
#include "tools/parlour/conversation_test/directive_reader.hpp"
#include "tools/parlour/conversation_test/expectation.hpp"
#include "tools/parlour/conversation_test/report.hpp"
#include "tools/parlour/talk/failure_context.hpp"
#include "tools/parlour/talk/trace.hpp"

namespace parlour::tools {

namespace {

// The session of `expect sql` messages: only watch() sees the answers.
const SessionId asking = "parlour test";

class Runner {
public:
  Runner(const Application& application, const Conversation& conversation,
         Coverage& coverage, const HoldOptions& options)
      : application_(application), conversation_(conversation),
        coverage_(coverage), options_(options),
        names_(application.composition) {
    result_.name = conversation.name;
    result_.file = conversation.file;
  }

  ConversationResult run() {
    const auto begin = std::chrono::steady_clock::now();
    if (start())
      hold();
    if (node_)
      hide_in(result_,
              [this](const auto& text) { return node_->masked(text); });
    node_ = nullptr;
    const auto took = std::chrono::steady_clock::now() - begin;
    result_.seconds = std::chrono::duration<double>(took).count();
    return std::move(result_);
  }

private:
  // -- the node ---------------------------------------------------------------

  bool start() {
    if (is_spoken(conversation_)) {
      if (!options_.seats)
        return fail_at(0, "a voice", "no line can be spoken here");
      voice_ = options_.seats->make();
    }
    const auto& application =
        voice_ ? options_.seats->application() : application_;
    auto data = DataFolder::temporary();
    if (!data)
      return fail_at(0, "a folder for data", data.error().message);
    data_.emplace(std::move(*data));
    RunWishes wishes{data_->path().string(), conversation_.start,
                     conversation_.seed, options_.restores_after_each_input};
    auto composition = rehearsed(application.composition);
    if (voice_)
      composition = voice_->seated(std::move(composition), data_->path());
    auto options = node_options(application, composition, wishes);
    options.on_inspection = [this](const Inspection& seen) { watch(seen); };
    options.exact_inspections = true;
    options.log = [this](const std::string& text) {
      result_.trace.push_back("log         " + as_one_line(text));
    };
    auto node = actors::Node::start(std::move(options));
    if (!node)
      return fail_at(0, "the application starts", to_string(node.error()));
    node_ = std::move(*node);
    seat_ = node_->open_seat(
        {[this](const SessionId&, const dialogue::Output& output) {
           outputs_.emplace_back(trimmed(as_one_line(output.text)));
           last_output_ = output.id;
           if (voice_)
             voice_->released(output.id, output.text);
         },
         {}});
    session_ = node_->open(seat_);
    return true;
  }

  void watch(const Inspection& seen) {
    coverage_.note(seen);
    if (voice_)
      voice_->note(seen);
    if (seen.kind == InspectionKind::message && seen.message) {
      if (seen.message->session == asking) {
        if (seen.message->sinks.empty())
          answer_ = seen.message;
        return;
      }
      if (!seen.message->sinks.empty())
        posts_.push_back(seen.message);
    }
    if (seen.kind == InspectionKind::branch || seen.session == asking)
      return;
    has_error_ |= seen.kind == InspectionKind::error;
    context_.note(seen);
    result_.trace.push_back(trace_line(seen));
  }

  // -- the steps --------------------------------------------------------------

  void hold() {
    for (const auto& step : conversation_.steps)
      if (!take(step))
        return;
    const auto last =
        conversation_.steps.empty() ? 0 : conversation_.steps.back().line;
    settle();
    nothing_left(last, "the end of the conversation");
  }

  bool take(const Step& step) {
    if (!step.voice.empty())
      return speak(step);
    if (step.kind == StepKind::user)
      return user(step);
    enter_row();
    is_speaking_ = false;
    switch (step.kind) {
    case StepKind::robot:
    case StepKind::robot_pattern:
      return robot(step);
    case StepKind::wait:
      return pass(step.duration);
    case StepKind::clock:
      return clock(step);
    case StepKind::event:
      return inject(step, step.target, step.command, step.params);
    case StepKind::partial:
      return partial(step);
    case StepKind::barge_in:
      return barge_in(step);
    case StepKind::expect_post:
      return expect_post(step);
    case StepKind::expect_slot:
      return expect_slot(step);
    case StepKind::expect_state:
      return expect_state(step);
    case StepKind::expect_sql:
      return expect_sql(step);
    case StepKind::expect_first_sound:
      return expect_first_sound(step);
    case StepKind::user:
      break;
    }
    return true;
  }

  // Spoken lines that follow each other cut into what the robot says.
  bool speak(const Step& step) {
    enter_row();
    if (!std::exchange(is_speaking_, true)) {
      settle();
      if (step.kind != StepKind::barge_in)
        voice_->settle(*node_);
      if (!nothing_left(step.line, step.written))
        return false;
      begin_turn();
    }
    result_.said.push_back(step.written);
    voice_->speak(*node_, step);
    remember_session();
    return true;
  }

  // A partial result arrives while the row before it is still processed.
  bool partial(const Step& step) {
    result_.said.push_back("P: " + step.text);
    return inject(step, "ASR", "Partial", {step.text, 1});
  }

  // First the speaker reports what was heard, then the turn is entered.
  bool barge_in(const Step& step) {
    node_->run_until_quiet();
    remember_session();
    if (!nothing_left(step.line, step.written))
      return false;
    posts_.clear();
    result_.said.push_back(step.written);
    const auto id = static_cast<std::int64_t>(last_output_);
    if (!inject(step, "VAD", "SpeechStarted", {0}) ||
        !inject(step, "Speaker", "Finished", {id, 0, true, step.target}))
      return false;
    if (!step.text.empty())
      row_.push_back(step.text);
    enter_row();
    return true;
  }

  bool inject(const Step& step, std::string source, std::string command,
              std::vector<Value> params) {
    const auto session = node_->session_at(seat_);
    if (session.empty())
      return fail_at(step.line, step.written, "no session is open");
    Message message;
    message.source = std::move(source);
    message.command = std::move(command);
    message.params = std::move(params);
    node_->inject(session, std::move(message));
    return true;
  }

  // Collects the turns of a row; enter_row() enters them together.
  bool user(const Step& step) {
    if (row_.empty()) {
      settle();
      if (voice_)
        voice_->settle(*node_);
      if (!nothing_left(step.line, step.written))
        return false;
      begin_turn();
    }
    row_.push_back(step.text);
    result_.said.push_back("U: " + step.text);
    return true;
  }

  void begin_turn() {
    posts_.clear();
    context_.begin_turn();
    has_error_ = false;
  }

  void enter_row() {
    if (!row_.empty())
      node_->enter(seat_, std::exchange(row_, {}));
    remember_session();
  }

  // A session that has ended can still be asked for its slots.
  void remember_session() {
    if (auto session = node_->session_at(seat_); !session.empty())
      session_ = std::move(session);
  }

  void settle() {
    enter_row();
    node_->run_until_quiet();
    remember_session();
  }

  bool robot(const Step& step) {
    const auto said = next_output(step);
    if (!said)
      return fail_at(step.line, step.written,
                     "nothing was said within " +
                         std::to_string(longest_silence.count() / 1000) + " s");
    return is_as_expected(step, *said) || accept(step, *said) ||
           fail_at(step.line, step.written, result_.said.back());
  }

  bool accept(const Step& step, const std::string& said) {
    if (options_.words == Words::as_written || step.kind != StepKind::robot ||
        has_error_ || said.empty())
      return false;
    result_.rewordings.push_back({step.line, step.text, said});
    return true;
  }

  std::optional<std::string> next_output(const Step& step) {
    const auto deadline = node_->now() + longest_silence.count();
    node_->run_until_quiet();
    while (outputs_.empty() &&
           node_->step_to_next_due(Milliseconds(deadline - node_->now()))) {
    }
    if (outputs_.empty())
      return std::nullopt;
    const auto taken =
        outputs_for({&step, &conversation_.steps.back() + 1}, outputs_);
    for (const auto& output : taken) {
      result_.said.push_back("R: " + output);
      outputs_.pop_front();
    }
    return as_lines(taken);
  }

  bool nothing_left(std::uint32_t line, const std::string& before) {
    if (outputs_.empty())
      return true;
    const auto& said = result_.said.emplace_back("R: " + outputs_.front());
    return fail_at(line, before, said);
  }

  bool pass(Milliseconds time) {
    settle();
    node_->advance(time);
    return true;
  }

  bool clock(const Step& step) {
    settle();
    if (step.time < node_->now())
      return fail_at(step.line, step.written,
                     "it is already " +
                         format_timestamp(node_->now(), "%Y-%m-%d %H:%M:%S"));
    return pass(Milliseconds(step.time - node_->now()));
  }

  // -- expectations -----------------------------------------------------------

  bool expect_post(const Step& step) {
    settle();
    std::string found;
    for (const auto& post : posts_) {
      if (is_as_expected(step, *post, names_))
        return true;
      found += (found.empty() ? "" : "; ") + to_string(*post);
    }
    return fail_at(step.line, step.written,
                   found.empty() ? "nothing was posted since the last U"
                                 : "posted since the last U: " + found);
  }

  bool expect_slot(const Step& step) {
    settle();
    const auto value = node_->slot_value(session_, step.text, step.target);
    return is_as_expected(step.value, value) ||
           fail_at(step.line, step.written,
                   step.text + "." + step.target + " = " + to_string(value));
  }

  bool expect_state(const Step& step) {
    settle();
    const auto state = node_->state(session_);
    return state == step.text ||
           fail_at(step.line, step.written,
                   state.empty() ? "no state is active" : "state " + state);
  }

  bool expect_sql(const Step& step) {
    settle();
    answer_ = nullptr;
    node_->inject(asking, sql_question(step.text));
    node_->run_until_quiet();
    if (!answer_)
      return fail_at(step.line, step.written, "no database answered");
    const auto first = answer_->params.empty() ? Value() : answer_->params[0];
    const auto* rows = first.if_result();
    if (!rows)
      return fail_at(step.line, step.written, to_string(*answer_));
    const auto found = cells_of(*rows);
    return is_as_expected(step.value, found) ||
           fail_at(step.line, step.written,
                   rows->cells.empty() ? "no row" : to_string(found));
  }

  bool expect_first_sound(const Step& step) {
    const auto took = voice_->first_sound(*node_);
    return (took && *took < step.duration) ||
           fail_at(step.line, step.written,
                   took ? std::to_string(took->count()) + " ms"
                        : "the robot made no sound");
  }

  bool fail_at(std::uint32_t line, std::string expected, std::string found) {
    result_.failure = Failure{line, std::move(expected), std::move(found)};
    result_.context = context_.lines();
    return false;
  }

  const Application& application_;
  const Conversation& conversation_;
  Coverage& coverage_;
  HoldOptions options_;
  ModuleNames names_;
  FailureContext context_;
  bool has_error_ = false; // of a script, since the last U
  ConversationResult result_;
  std::deque<std::string> outputs_;
  std::vector<std::shared_ptr<const Message>> posts_; // since the last U
  std::shared_ptr<const Message> answer_;             // to `expect sql`
  std::vector<std::string> row_;
  dialogue::OutputId last_output_ = 0;
  actors::SeatId seat_;
  SessionId session_;
  std::unique_ptr<SpokenSeat> voice_; // null: all lines are typed
  bool is_speaking_ = false;          // the line before was spoken, too
  std::optional<DataFolder> data_;    // must outlive the node
  std::unique_ptr<actors::Node> node_;
};

} // namespace

ConversationResult hold_conversation(const Application& application,
                                     const Conversation& conversation,
                                     Coverage& coverage,
                                     const HoldOptions& options) {
  return Runner(application, conversation, coverage, options).run();
}

} // namespace parlour::tools
