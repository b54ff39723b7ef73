#include "tools/parlour/voice_test/row_runner.hpp"

#include <algorithm>
#include <utility>

#include "tools/parlour/application/data_folder.hpp"
#include "tools/parlour/application/node_options.hpp"
#include "tools/parlour/conversation_test/conversation_runner.hpp"
#include "tools/parlour/conversation_test/directive_reader.hpp"
#include "tools/parlour/talk/trace.hpp"
#include "tools/parlour/voice_test/voice_user.hpp"

namespace parlour::tools {

namespace {

class RowRunner {
public:
  RowRunner(const Application& application, const Conversation& conversation)
      : application_(application), conversation_(conversation) {}

  RowRunner& by_voice(const Speaking& speaking,
                      const std::vector<Row>& expected, std::size_t typed) {
    speaking_ = &speaking;
    expected_ = &expected;
    typed_ = typed;
    user_.emplace(speaking.noise, speaking.told, speaking.recognisers);
    return *this;
  }

  RowsHeld run() {
    if (start())
      hold();
    node_ = nullptr;
    return std::move(held_);
  }

private:
  bool start() {
    auto data = DataFolder::temporary();
    if (!data)
      return give_up(data.error());
    data_.emplace(std::move(*data));
    auto composition = rehearsed(application_.composition);
    if (user_)
      composition = user_->seated(std::move(composition), data_->path());
    auto options = node_options(
        application_, composition,
        {data_->path().string(), conversation_.start, conversation_.seed});
    options.on_inspection = [this](const Inspection& seen) {
      log().note(seen);
    };
    options.exact_inspections = true;
    auto node = actors::Node::start(std::move(options));
    if (!node)
      return give_up(node.error());
    node_ = std::move(*node);
    seat_ = node_->open_seat(
        {[this](const SessionId&, const dialogue::Output& output) {
           log().released(output.id,
                          std::string(trimmed(as_one_line(output.text))));
         },
         {}});
    node_->open(seat_);
    return true;
  }

  bool give_up(const Error& error) {
    held_.trouble = to_string(error);
    return false;
  }

  // -- the steps --------------------------------------------------------------

  void hold() {
    for (const auto& step : conversation_.steps) {
      if (step.kind == StepKind::user) {
        lines_.push_back(&step);
        continue;
      }
      if (!lines_.empty() && !enter_row())
        return;
      take(step);
    }
    if (lines_.empty() || enter_row())
      (void)close_row();
  }

  void take(const Step& step) {
    switch (step.kind) {
    case StepKind::robot:
    case StepKind::robot_pattern:
      ++awaited_;
      return VoiceUser::until(
          *node_, [this] { return log().answers().size() >= awaited_; },
          longest_silence);
    case StepKind::wait:
      settle();
      return node_->advance(step.duration);
    case StepKind::clock:
      settle();
      if (step.time > node_->now())
        node_->advance(Milliseconds(step.time - node_->now()));
      return;
    case StepKind::event:
      return inject(step);
    default: // expectations are those of the run by text
      return;
    }
  }

  void inject(const Step& step) {
    Message message;
    message.source = step.target;
    message.command = step.command;
    message.params = step.params;
    node_->inject(node_->session_at(seat_), std::move(message));
  }

  // The user's lines, after what came of those before. False: the conversation
  // has taken another way than by text.
  bool enter_row() {
    if (!close_row())
      return false;
    auto& row = held_.rows.emplace_back();
    row.line = lines_.front()->line;
    for (const auto* line : lines_)
      row.said.push_back(line->text);
    lines_.clear();
    log().begin_row();
    awaited_ = 0;
    if (is_spoken())
      speak(row);
    else
      node_->enter(seat_, row.said);
    return true;
  }

  bool is_spoken() const {
    return user_ && held_.rows.size() > typed_;
  }

  // True if there is no row yet, or it went as expected.
  bool close_row() {
    settle();
    if (held_.rows.empty())
      return true;
    auto& row = held_.rows.back();
    row.heard = log().heard();
    row.understood = log().understood();
    row.answers = log().answers();
    row.latencies = log().latencies();
    return !is_spoken() || (held_.rows.size() <= expected_->size() &&
                            row.is_as((*expected_)[held_.rows.size() - 1]));
  }

  // -- speaking ---------------------------------------------------------------

  void speak(const Row& row) {
    user_->think(*node_);
    for (std::size_t i = 0; i < row.said.size(); ++i) {
      if (i > 0)
        user_->wait_to_cut_in(*node_);
      user_->say(*node_, *speaking_->bank->find(row.said[i], speaking_->voice));
    }
  }

  // By voice, the robot speaks to the end of what it says now.
  void settle() {
    node_->run_until_quiet();
    if (user_)
      user_->settle(*node_);
  }

  TurnLog& log() {
    return user_ ? user_->log() : log_;
  }

  const Application& application_;
  const Conversation& conversation_;
  const Speaking* speaking_ = nullptr;
  const std::vector<Row>* expected_ = nullptr;
  std::size_t typed_ = 0;
  std::optional<VoiceUser> user_; // nothing: by text
  TurnLog log_;                   // by text
  RowsHeld held_;
  std::vector<const Step*> lines_; // of the row that is read
  std::size_t awaited_ = 0;        // answers, by `R:`
  actors::SeatId seat_;
  std::optional<DataFolder> data_; // must outlive the node
  std::unique_ptr<actors::Node> node_;
};

} // namespace

std::string unspeakable(const Conversation& conversation) {
  for (const auto& step : conversation.steps)
    if (step.kind == StepKind::partial || step.kind == StepKind::barge_in)
      return "line " + std::to_string(step.line) +
             " says what a recogniser or a speaker reports";
  return {};
}

RowsHeld hold_by_text(const Application& application,
                      const Conversation& conversation) {
  return RowRunner(application, conversation).run();
}

RowsHeld hold_by_voice(const Application& application,
                       const Conversation& conversation,
                       const Speaking& speaking,
                       const std::vector<Row>& expected, std::size_t typed) {
  return RowRunner(application, conversation)
      .by_voice(speaking, expected, typed)
      .run();
}

} // namespace parlour::tools
