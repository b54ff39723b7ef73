#include "tools/parlour/speech/ears.hpp"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "tools/parlour/application/plugins/plugin_calls.hpp"
#include "tools/parlour/speech/application_host.hpp"

namespace parlour::tools {

namespace {

using adapters::frame_time;
using adapters::Sample;
using Messages = std::vector<Message>;

constexpr Milliseconds silence{2'000};
constexpr Milliseconds answer_time{60'000};
// A component that works aside and says nothing for so long is taken for
// available.
constexpr Milliseconds opening_time{3'000};

const Value& param(const Message& message, std::size_t position) {
  static const Value missing;
  return position < message.params.size() ? message.params[position] : missing;
}

std::int64_t position_of(const Message& message) {
  return param(message, 0).integer_or(0);
}

List list_of(const Value& value) {
  const auto* const list = value.if_list();
  return list ? *list : List();
}

} // namespace

// A component that runs alone.
class Ears::Stage {
public:
  static Expected<std::unique_ptr<Stage>> start(const Application& application,
                                                std::string_view role) {
    const auto* const chosen = first_of_role(application.composition, role);
    if (!chosen)
      return nullptr;
    std::unique_ptr<Stage> stage(new Stage(application, *chosen));
    auto started = start_plugin(chosen->factory, stage->host_, chosen->options);
    if (!started)
      return fail(started.error().kind,
                  chosen->name + ": " + to_string(started.error()));
    stage->plugin_ = std::move(*started);
    return stage;
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  ~Stage() {
    if (plugin_)
      stop_plugin(*plugin_);
  }

  const std::string& name() const {
    return name_;
  }
  // Whether it answers from a thread of its own.
  bool works_aside() const {
    return works_aside_;
  }
  // Waits for one that works aside, at the first time for what it says.
  bool becomes_available() {
    if (works_aside_ &&
        (!std::exchange(awaited_, true) || host_.is_surely_unavailable()))
      call([&] {
        host_.wait([&] { return host_.is_surely_available(); }, opening_time);
      });
    return !host_.is_surely_unavailable();
  }
  // What it has thrown since it was asked last.
  const std::optional<Error>& trouble() const {
    return trouble_;
  }
  std::optional<Error> take_trouble() {
    return std::exchange(trouble_, std::nullopt);
  }

  // What it fires at once, and what it has fired meanwhile.
  Messages take(std::string command, std::vector<Value> params = {}) {
    Message message;
    message.session = "listen";
    message.command = std::move(command);
    message.params = std::move(params);
    call([&] { plugin_->receive(message); });
    return host_.take_events();
  }
  Messages pass(Milliseconds time) {
    call([&] { host_.advance(time); });
    return host_.take_events();
  }
  // Its events up to one of these; all of them if none comes.
  Messages wait_for(std::initializer_list<std::string_view> commands) {
    Messages all;
    auto has_come = [&] {
      const auto more = host_.take_events();
      all.insert(all.end(), more.begin(), more.end());
      return std::ranges::any_of(all, [&](const Message& event) {
        return std::ranges::find(commands, event.command) != commands.end();
      });
    };
    call([&] { host_.wait(has_come, answer_time); });
    return all;
  }

private:
  Stage(const Application& application, const ChosenComponent& chosen)
      : host_(application), name_(chosen.name),
        works_aside_(std::ranges::any_of(
            chosen.factory.description.options, [&](const auto& option) {
              return option.name == "one-by-one" &&
                     option_value(chosen.options,
                                  chosen.factory.description.options,
                                  option.name) != "true";
            })) {}

  void call(const std::function<void()>& action) {
    const auto called = call_plugin(action);
    if (!called && !trouble_)
      trouble_ = {
          called.error().kind, name_ + ": " + called.error().message, {}};
  }

  ApplicationHost host_; // outlives the plug-in
  std::unique_ptr<IPlugin> plugin_;
  const std::string name_;
  const bool works_aside_;
  bool awaited_ = false;
  std::optional<Error> trouble_;
};

// The way of one file through the stages.
class Ears::Hearing {
public:
  explicit Hearing(Ears& ears) : ears_(ears) {
    heard_.sleeps = ears.spotter_ != nullptr;
  }

  void frame(const std::vector<Sample>& samples) {
    heard_.level.add(samples);
    enhance(adapters::pcm_value(samples));
    position_ += frame_time;
    heard_.length = position_;
    pass(Milliseconds(frame_time));
  }
  bool has_trouble() const {
    return trouble_.has_value();
  }

  // A turn that is still open ends when no more audio comes.
  Expected<HeardFile> finish() {
    for (int second = 0; second < 2; ++second)
      pass(Milliseconds(1'000));
    if (trouble_)
      return tl::make_unexpected(*trouble_);
    return std::move(heard_);
  }

private:
  void pass(Milliseconds time) {
    if (ears_.enhancement_)
      enhanced(ears_.enhancement_->pass(time));
    detector(ears_.detector_->pass(time));
    if (ears_.spotter_)
      spotter(ears_.spotter_->pass(time));
    endpointer(ears_.endpointer_->pass(time));
    recogniser(ears_.recogniser_->pass(time));
    for (auto* const stage : ears_.stages())
      if (auto trouble = stage->take_trouble())
        trouble_ = std::move(trouble);
  }

  void enhance(const Value& audio) {
    if (!ears_.enhancement_)
      return detect(audio, position_);
    enhanced(ears_.enhancement_->take("Process", {audio, position_}));
  }

  void enhanced(const Messages& events) {
    for (const auto& event : events)
      if (event.command == "Enhanced")
        detect(param(event, 0), param(event, 1).integer_or(position_));
  }

  void detect(const Value& audio, std::int64_t position) {
    detector(ears_.detector_->take("Process", {audio, position}));
    if (ears_.spotter_)
      spotter(ears_.spotter_->take("Process", {audio, position}));
    endpointer(ears_.endpointer_->take("Process", {audio, position}));
  }

  void detector(const Messages& events) {
    for (const auto& event : events) {
      if (event.command == "SpeechStarted")
        heard_.speech.push_back({position_of(event), position_of(event)});
      else if (event.command == "SpeechEnded" && !heard_.speech.empty())
        heard_.speech.back().end = position_of(event);
      else
        continue;
      endpointer(ears_.endpointer_->take(event.command, event.params));
    }
  }

  void spotter(const Messages& events) {
    for (const auto& event : events) {
      if (event.command != "Keyword")
        continue;
      heard_.keywords.push_back({param(event, 2).integer_or(position_),
                                 param(event, 0).text(), param(event, 1)});
      endpointer(ears_.endpointer_->take("Wake", {param(event, 2)}));
    }
  }

  void endpointer(const Messages& events) {
    for (const auto& event : events)
      if (event.command == "TurnStarted")
        heard_.turns.push_back({position_of(event), position_of(event)});
      else if (event.command == "Speech")
        recogniser(ears_.recogniser_->take("DoRecognition", event.params));
      else if (event.command == "TurnEnded")
        end(position_of(event));
      else if (event.command == "TurnDropped")
        drop();
  }

  void drop() {
    recogniser(ears_.recogniser_->take("Cancel"));
    if (!heard_.turns.empty())
      heard_.turns.pop_back();
  }

  void end(std::int64_t position) {
    if (heard_.turns.empty())
      return;
    heard_.turns.back().end = position;
    recogniser(ears_.recogniser_->take("Finish"));
    if (is_open() && !ears_.recogniser_->trouble())
      recogniser(ears_.recogniser_->wait_for(
          {"RecognitionResult", "Rejected", "Failed"}));
    if (is_open())
      trouble_ = {
          ErrorKind::offline, ears_.recogniser() + " has not answered", {}};
  }

  bool is_open() const {
    const auto& turn = heard_.turns.back();
    return turn.text.empty() && turn.rejected.empty();
  }

  void recogniser(const Messages& events) {
    for (const auto& event : events)
      if (!heard_.turns.empty())
        recognised(event, heard_.turns.back());
  }

  void recognised(const Message& event, HeardTurn& turn) {
    if (event.command == "Partial") {
      const auto* const ends = param(event, 2).if_boolean();
      turn.partials.push_back({position_, param(event, 0).text(),
                               ends ? std::optional(*ends) : std::nullopt});
      endpointer(ears_.endpointer_->take("Partial", event.params));
    } else if (event.command == "RecognitionResult") {
      turn.text = param(event, 0).text();
      turn.confidence = param(event, 1);
      turn.alternatives = list_of(param(event, 2));
      turn.words = list_of(param(event, 3));
    } else if (event.command == "Rejected" || event.command == "Failed") {
      turn.rejected = param(event, 0).text();
      if (turn.rejected.empty())
        turn.rejected = "it does not say why";
    }
  }

  Ears& ears_;
  HeardFile heard_;
  std::int64_t position_ = 0; // where the next frame begins
  std::optional<Error> trouble_;
};

Ears::Ears() = default;

Ears::~Ears() = default;

Expected<std::unique_ptr<Ears>> Ears::start(const Application& application) {
  std::unique_ptr<Ears> ears(new Ears);
  const struct {
    std::string_view role;
    std::unique_ptr<Stage>& stage;
    bool required = true;
  } stages[] = {{"Enhancement", ears->enhancement_, false},
                {"KeywordSpotter", ears->spotter_, false},
                {"VAD", ears->detector_},
                {"Endpointer", ears->endpointer_},
                {"ASR", ears->recogniser_}};
  for (const auto& [role, stage, required] : stages) {
    auto started = Stage::start(application, role);
    if (!started)
      return tl::make_unexpected(started.error());
    stage = std::move(*started);
    if (required && !stage)
      return fail(ErrorKind::settings, "there is no component of the role " +
                                           std::string(role) +
                                           " (docs/speech.md)");
  }
  return ears;
}

std::vector<Ears::Stage*> Ears::stages() const {
  std::vector<Stage*> all;
  for (const auto* stage :
       {&enhancement_, &spotter_, &detector_, &endpointer_, &recogniser_})
    if (*stage)
      all.push_back(stage->get());
  return all;
}

const std::string& Ears::recogniser() const {
  return recogniser_->name();
}

Expected<void> Ears::begin() {
  for (auto* const stage : stages())
    if (!stage->becomes_available())
      return fail(ErrorKind::offline, stage->name() + " is not available");
  detector_->take("Reset");
  endpointer_->take("Reset");
  if (spotter_)
    endpointer_->take("Sleep");
  recogniser_->take("Cancel");
  return {};
}

Expected<HeardFile> Ears::hear(const std::filesystem::path& file) {
  auto frames = adapters::SoundFileFrames::open(file, {}, {silence, false});
  if (!frames)
    return tl::make_unexpected(frames.error());
  if (auto begun = begin(); !begun)
    return tl::make_unexpected(begun.error());
  Hearing hearing(*this);
  std::vector<Sample> frame;
  const bool is_paced = std::ranges::any_of(
      stages(), [](const auto* stage) { return stage->works_aside(); });
  auto due = std::chrono::steady_clock::now();
  while (!hearing.has_trouble() && frames->next(frame)) {
    hearing.frame(frame);
    due += Milliseconds(frame_time);
    if (is_paced)
      std::this_thread::sleep_until(due);
  }
  return hearing.finish();
}

Expected<HeardFile> Ears::hear(std::span<const Sample> sound) {
  if (auto begun = begin(); !begun)
    return tl::make_unexpected(begun.error());
  Hearing hearing(*this);
  constexpr auto size = adapters::frame_samples;
  for (std::size_t at = 0; at < sound.size() && !hearing.has_trouble();
       at += size) {
    const auto part =
        sound.subspan(at, std::min<std::size_t>(size, sound.size() - at));
    std::vector<Sample> frame(part.begin(), part.end());
    frame.resize(size);
    hearing.frame(frame);
  }
  return hearing.finish();
}

} // namespace parlour::tools
