#include "adapters/wyoming/wyoming_asr.hpp"

#include <chrono>
#include <map>
#include <utility>

#include "adapters/audio/pcm.hpp"
#include "adapters/wyoming/audio_events.hpp"
#include "adapters/wyoming/client.hpp"

namespace parlour::adapters {

namespace {

using Steady = std::chrono::steady_clock;

// Each has a connection; far more than a recogniser can follow.
constexpr std::size_t max_turns = 64; // at a time, of as many sessions
// A turn that is not spoken on for so long may be given up for another one's
// sake: its session may have ended.
constexpr Milliseconds idle_time{30'000};
// How long an answer may take in all, from a server that says other things.
constexpr Milliseconds longest_answer{60'000};
// Of one turn: a sentence has some hundred.
constexpr std::size_t longest_text = wyoming::max_text / 2; // in bytes
constexpr const char* too_slow = "it takes too little of what is sent";

const std::vector<OptionDescription>& descriptions() {
  static const auto all = [] {
    auto options = wyoming::client_options("10300");
    options.push_back(
        {"model", "", "what recognises; else as the server likes"});
    options.push_back({"language", "", "such as en; else as the server likes"});
    return options;
  }();
  return all;
}

} // namespace

// The turns that are spoken now, on the client's loop.
//
// A turn begins with its first audio and ends with one answer to Finish. What
// goes wrong before Finish is kept in `trouble`, as nobody may be answered
// then.
//
// A turn, and what the server hears and says:
//
//   DoRecognition   connects: transcribe, audio-start, audio-chunk
//   DoRecognition   audio-chunk ...         <- transcript-chunk: Partial
//   Finish          audio-stop              <- transcript: RecognitionResult
//                                              or the time is over: Rejected
class WyomingASR::Turns {
public:
  Turns(WyomingASR& plugin, std::unique_ptr<wyoming::Client> client,
        const Options& options)
      : plugin_(plugin), client_(std::move(client)),
        model_(option_value(options, descriptions(), "model")),
        language_(option_value(options, descriptions(), "language")) {}
  Turns(const Turns&) = delete;
  Turns& operator=(const Turns&) = delete;
  // Answers those that wait.
  ~Turns() {
    client_->end([this] {
      while (!turns_.empty())
        reject(turns_.begin()->first, "the component was stopped");
    });
  }

  // Thread-safe.
  void hear(const Message& message, std::string samples) {
    const auto size = samples.size();
    client_->post(
        message.session,
        [this, message, samples = std::move(samples)] {
          heard(message, samples);
        },
        size,
        [this, message] {
          if (!turn_of(message).is_finished)
            closed(message.session, too_slow);
        });
  }
  // It has no audio, so that no bound holds for it: each Finish has to be
  // answered.
  void finish(Message message) {
    client_->post([this, message = std::move(message)] { finished(message); });
  }
  // A Finish that waits is answered by Rejected.
  void cancel(const SessionId& session) {
    client_->post([this, session] {
      if (turns_.contains(session))
        reject(session, "it was cancelled");
    });
  }
  bool is_one_by_one() const {
    return client_->is_one_by_one();
  }

private:
  struct Turn {
    Message order;                                   // of the last message
    std::unique_ptr<wyoming::Connection> connection; // null: it has failed
    std::string trouble;
    bool is_finished = false;
    Steady::time_point heard_at{};
    Steady::time_point latest_answer{};
    std::int64_t position = 0; // ms
    std::string partial;
    std::int64_t revision = 0;
  };

  // The session's turn, which begins if there is none.
  // A turn beyond the bound exists, too, so that its Finish can be answered
  // with the reason.
  Turn& turn_of(const Message& message) {
    const auto found = turns_.find(message.session);
    if (found != turns_.end())
      return found->second;
    if (turns_.size() >= max_turns)
      forget_idle();
    auto& turn = turns_[message.session];
    turn.order = message;
    turn.heard_at = Steady::now();
    if (turns_.size() > max_turns)
      turn.trouble = "too many turns are spoken at the same time";
    else
      open(turn, message.session);
    return turn;
  }

  // Nobody waits for these: they have not been finished.
  void forget_idle() {
    const auto latest = Steady::now() - idle_time;
    std::erase_if(turns_, [&](const auto& one) {
      return !one.second.is_finished && one.second.heard_at < latest;
    });
  }

  // The order is that of the last message, so that a Partial answers what came
  // last.
  void heard(const Message& message, const std::string& samples) {
    auto& turn = turn_of(message);
    turn.heard_at = Steady::now();
    // What comes before the result is there belongs to no turn.
    if (turn.is_finished || !turn.connection)
      return;
    turn.order = message;
    const auto event = wyoming::audio_chunk(samples, turn.position);
    turn.position += wyoming::duration_of(samples);
    turn.connection->send(event);
  }

  // Begins to connect; audio that comes meanwhile waits in the connection.
  void open(Turn& turn, const SessionId& session) {
    wyoming::Event transcribe{"transcribe"};
    if (!model_.empty())
      transcribe.data["name"] = model_;
    if (!language_.empty())
      transcribe.data["language"] = language_;
    turn.connection = client_->connect(session, calls_, transcribe);
  }

  // A second Finish before the first is answered is refused, whatever audio
  // came between.
  void finished(const Message& message) {
    const auto found = turns_.find(message.session);
    if (found == turns_.end())
      return answer(message, "Rejected", {"there was no speech"});
    auto& turn = found->second;
    if (std::exchange(turn.is_finished, true))
      return answer(message, "Rejected", {"the turn before is recognised yet"});
    turn.order = message;
    turn.latest_answer =
        Steady::now() + std::max(longest_answer, client_->answer_timeout());
    if (!turn.connection)
      return reject(message.session, turn.trouble);
    turn.connection->expect(client_->answer_timeout());
    turn.connection->send(wyoming::audio_stop(turn.position));
  }

  // Only what the server says after the whole turn was sent is its result.
  // Other events show that it is alive, but not for longer than
  // `longest_answer`.
  void received(const SessionId& session, const wyoming::Event& event) {
    auto& turn = turns_.at(session);
    const auto text = wyoming::trimmed(wyoming::text_of(event.data, "text"));
    if (event.type == "transcript" && turn.is_finished) {
      if (text.size() > longest_text)
        return reject(session, "the result is no sentence");
      if (text.empty())
        return reject(session, "nothing was recognised");
      return end(session, "RecognitionResult", {text, Value(), List{}});
    }
    if (event.type == "error")
      return closed(session, "it reports an error: " + text);
    if (event.type == "transcript-chunk")
      partial(turn, wyoming::text_of(event.data, "text"));
    if (!turn.is_finished)
      return;
    if (Steady::now() > turn.latest_answer)
      return closed(session, "it does not answer in time");
    turn.connection->expect(client_->answer_timeout());
  }

  // The server tells pieces that follow each other; a Partial has all so far.
  void partial(Turn& turn, const std::string& text) {
    if (text.empty() || turn.partial.size() + text.size() > longest_text)
      return;
    turn.partial += text;
    plugin_.answer(turn.order, "Partial",
                   {wyoming::trimmed(turn.partial), ++turn.revision});
  }

  // A turn that has failed stays until it is finished or cancelled.
  void closed(const SessionId& session, const std::string& reason) {
    auto& turn = turns_.at(session);
    if (turn.is_finished)
      return reject(session, reason);
    turn.trouble = reason;
    turn.connection.reset();
  }

  void reject(const SessionId& session, const std::string& reason) {
    if (turns_.at(session).is_finished)
      end(session, "Rejected", {reason});
    else
      turns_.erase(session);
  }

  void end(const SessionId& session, const std::string& command,
           std::vector<Value> params) {
    const auto turn = turns_.extract(session);
    answer(turn.mapped().order, command, std::move(params));
  }
  // The message counts as answered when the event is fired.
  void answer(const Message& to, const std::string& command,
              std::vector<Value> params) {
    const OpenMessages::Closing closing(plugin_.open_);
    plugin_.answer(to, command, std::move(params));
  }

  WyomingASR& plugin_;
  const wyoming::SessionCalls calls_{
      [this](const SessionId& session, const wyoming::Event& event) {
        received(session, event);
      },
      [this](const SessionId& session, const std::string& reason) {
        closed(session, reason);
      }};
  const std::unique_ptr<wyoming::Client> client_;
  const std::string model_;
  const std::string language_;
  std::map<SessionId, Turn> turns_;
};

WyomingASR::WyomingASR() = default;

WyomingASR::~WyomingASR() = default;

Expected<void> WyomingASR::on_start(const Options& options) {
  auto client = wyoming::Client::start(host(), options, descriptions(), "asr");
  if (!client)
    return tl::make_unexpected(client.error());
  turns_ = std::make_unique<Turns>(*this, std::move(*client), options);
  return {};
}

void WyomingASR::stop() {
  turns_.reset();
}

void WyomingASR::on_do_recognition(const Binary& audio) {
  const auto samples = speech_samples(audio);
  if (!samples)
    return refuse(samples.error().message);
  if (audio.bytes.size() > wyoming::longest_audio)
    return refuse("so much audio comes in several messages");
  auto order = without_its_way(current());
  order.params.clear(); // the samples travel by themselves
  turns_->hear(order, wyoming::bytes_of(*samples));
}

void WyomingASR::on_finish() {
  open_.open();
  turns_->finish(without_its_way(current()));
  if (turns_->is_one_by_one())
    open_.wait_for_all();
}

void WyomingASR::on_cancel() {
  turns_->cancel(current().session);
}

PluginFactory wyoming_asr_factory() {
  PluginDescription description;
  description.name = "WyomingASR";
  description.roles = {"ASR"};
  description.sentence = "has speech recognised by a server of the Wyoming "
                         "protocol: faster-whisper, vosk";
  description.options = descriptions();
  return {description, [] { return std::make_unique<WyomingASR>(); }};
}

} // namespace parlour::adapters
