#include "adapters/vad/silero_vad.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "adapters/asr/moonshine_place.hpp"
#include "adapters/asr/moonshine_program.hpp"
#include "adapters/vad/detector_options.hpp"
#include "adapters/vad/silero_stream.hpp"
#include "runtime/plugin/adaptors.hpp"
#include "runtime/plugin/open_messages.hpp"

namespace parlour::adapters {

namespace {

using namespace moonshine;

using Folders = std::vector<std::filesystem::path>;

constexpr std::size_t most_streams = 64;

const std::vector<OptionDescription>& options() {
  static const auto descriptions = detector_options(
      {{"program", "",
        "the file moonshine.mjs; its packages are beside it. Otherwise the one "
        "that comes with Parlour"},
       {"node", "node", "Node.js, a name or a path"},
       {"one-by-one", "false",
        "answers each message before the next; virtual time sets it", false,
        OptionType::boolean}});
  return descriptions;
}

// Threads: commands come on the plug-in's own thread; answers of the program
// come on its loop's thread.
class SileroVAD : public VADPlugin {
public:
  explicit SileroVAD(Folders programs) : programs_(std::move(programs)) {}
  void stop() override;

private:
  // Of one session.
  struct Stream {
    TurnNumber number = 0;
    SileroStream heard;
    Message order; // what its events answer
  };
  using Streams = std::map<SessionId, Stream>;

  Expected<void> on_start(const Options& given) override;
  void on_process(const Binary& audio,
                  std::optional<std::int64_t> position) override;
  void on_set_echo(const Binary& audio) override;
  void on_reset() override;

  Expected<ProgramOrder> program_order(const Options& given) const;
  ProgramCalls calls();
  Stream& stream(std::optional<std::int64_t> position);
  Stream& begin(std::int64_t position);
  void forget(Streams::iterator stream);
  void drop_oldest();
  void take(const Answer& answer);
  void tell(const Message& order, const std::vector<SpeechEdge>& edges);
  void program_ended(const std::string& reason);

  const Folders programs_;
  DetectorOptions detector_;
  bool one_by_one_ = false;
  OpenMessages open_;
  std::mutex mutex_;
  TurnNumber last_ = 0;
  Streams streams_;
  std::map<TurnNumber, int> owed_; // answers, by stream
  bool has_ended_ = false;
  // Destroyed first: it calls.
  std::unique_ptr<MoonshineProgram> program_;
};

Expected<ProgramOrder> SileroVAD::program_order(const Options& given) const {
  const auto* const path = std::getenv("PATH");
  PlaceOrder wanted{option_value(given, options(), "program"), programs_,
                    option_value(given, options(), "node"), path ? path : ""};
  wanted.plugin = "SileroVAD";
  wanted.otherwise = "AdaptiveVAD";
  wanted.packages = silero_packages();
  return find_place(wanted).map([](const Place& place) {
    ProgramOrder order;
    order.program = place.node;
    order.arguments = {place.program.string(), "--detect"};
    return order;
  });
}

Expected<void> SileroVAD::on_start(const Options& given) {
  const auto read = read_detector_options(given);
  if (!read)
    return tl::make_unexpected(read.error());
  detector_ = *read;
  one_by_one_ = option_value(given, options(), "one-by-one") == "true";
  const auto order = program_order(given);
  if (!order)
    return tl::make_unexpected(order.error());
  auto program = MoonshineProgram::start(*order, calls());
  if (!program)
    return fail(program.error().kind,
                "the detector's program " + order->arguments.front() +
                    " does not start: " + program.error().message);
  program_ = std::move(*program);
  return {};
}

ProgramCalls SileroVAD::calls() {
  return {[this](const Answer& answer) { take(answer); },
          [this](Milliseconds time) {
            host().log("The detector is ready, after " +
                       std::to_string(time.count()) + " ms.");
          },
          [this](const std::string& reason) { program_ended(reason); },
          [this](const std::string& line) { host().log(line); }};
}

void SileroVAD::stop() {
  program_.reset();
  program_ended("");
}

// -- commands
// ------------------------------------------------------------------

void SileroVAD::on_process(const Binary& audio,
                           std::optional<std::int64_t> position) {
  const Value value(audio);
  const auto samples = speech_samples(value);
  if (!samples)
    return refuse(samples.error().message);
  {
    const std::lock_guard lock(mutex_);
    if (has_ended_ || samples->empty())
      return;
    auto& own = stream(position);
    own.heard.hear(*samples);
    ++owed_[own.number];
    open_.open();
    program_->ask(own.number, detect_frame(own.number, *samples));
  }
  if (one_by_one_)
    open_.wait_for_all();
}

void SileroVAD::on_set_echo(const Binary& audio) {
  const Value value(audio);
  const auto samples = speech_samples(value);
  if (!samples)
    return refuse(samples.error().message);
  const std::lock_guard lock(mutex_);
  const auto found = streams_.find(current().session);
  (found == streams_.end() ? begin(0) : found->second)
      .heard.hear_echo(*samples);
}

void SileroVAD::on_reset() {
  const std::lock_guard lock(mutex_);
  if (const auto found = streams_.find(current().session);
      found != streams_.end())
    forget(found);
}

// -- streams, under the lock
// ---------------------------------------------------

// Audio that does not follow is another stream, in the same room.
SileroVAD::Stream& SileroVAD::stream(std::optional<std::int64_t> position) {
  const auto found = streams_.find(current().session);
  if (found == streams_.end())
    return begin(position.value_or(0));
  auto& own = found->second;
  own.order = without_its_way(current());
  if (!position || own.heard.follows(*position))
    return own;
  tell(own.order, own.heard.finish());
  const auto before = own.heard;
  forget(found);
  auto& next = begin(*position);
  next.heard.continue_echo(before);
  return next;
}

SileroVAD::Stream& SileroVAD::begin(std::int64_t position) {
  drop_oldest();
  const SileroStream heard(detector_.hangover, detector_.echo_loss, position);
  return streams_
      .insert_or_assign(current().session,
                        Stream{++last_, heard, without_its_way(current())})
      .first->second;
}

void SileroVAD::forget(Streams::iterator stream) {
  if (!has_ended_)
    program_->send(cancel_frame(stream->second.number));
  streams_.erase(stream);
}

void SileroVAD::drop_oldest() {
  if (streams_.size() >= most_streams)
    forget(std::ranges::min_element(
        streams_, {}, [](const auto& one) { return one.second.number; }));
}

// -- on the thread of the program's loop
// ---------------------------------------

// Answers for a stream that is forgotten count, but say nothing any more.
void SileroVAD::take(const Answer& answer) {
  if (answer.kind != AnswerKind::speech)
    return;
  const std::lock_guard lock(mutex_);
  const auto owed = owed_.find(answer.turn);
  if (owed == owed_.end())
    return;
  if (--owed->second == 0)
    owed_.erase(owed);
  const OpenMessages::Closing closing(open_);
  const auto found = std::ranges::find_if(streams_, [&](const auto& one) {
    return one.second.number == answer.turn;
  });
  if (found != streams_.end())
    tell(found->second.order, found->second.heard.judged(answer.likely));
}

void SileroVAD::tell(const Message& order,
                     const std::vector<SpeechEdge>& edges) {
  for (const auto& edge : edges)
    answer(order, edge.begins ? "SpeechStarted" : "SpeechEnded",
           {edge.position});
}

// Whoever waits is told nothing any more.
void SileroVAD::program_ended(const std::string& reason) {
  {
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
    for (const auto& [stream, answers] : std::exchange(owed_, {}))
      for (int i = 0; i < answers; ++i)
        open_.close();
    streams_.clear();
  }
  if (!reason.empty())
    host().failed("The detector's program has ended: " + reason);
}

} // namespace

std::vector<std::string> silero_packages() {
  return {"onnxruntime-node", "@ricky0123/vad-web"};
}

PluginFactory silero_vad_factory(Folders programs) {
  PluginDescription description;
  description.name = "SileroVAD";
  description.roles = {"VAD"};
  description.sentence =
      "finds speech by a neural network that knows voices; needs Node.js";
  description.options = options();
  return {std::move(description), [programs = std::move(programs)] {
            return std::make_unique<SileroVAD>(programs);
          }};
}

} // namespace parlour::adapters
