#include "adapters/wyoming/remote_synthesizer.hpp"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

#include "adapters/wyoming/audio_events.hpp"

namespace parlour::adapters::wyoming {

namespace {

// How long after Stop the engine may still wait for the server.
constexpr Milliseconds look_up{50};
constexpr std::int64_t character_time = 65; // ms, of usual speech
// What one piece may be, however long the server talks.
constexpr std::int64_t longest_piece = 120'000; // ms

// Between the loop, which receives, and the engine, which waits.
class Answers {
public:
  void put(Event event) {
    const std::lock_guard lock(mutex_);
    events_.push_back(std::move(event));
    changed_.notify_all();
  }
  void end(const std::string& reason) {
    const std::lock_guard lock(mutex_);
    trouble_ = reason;
    changed_.notify_all();
  }
  // The next event; the reason if there will be none; neither if none comes
  // within the time.
  std::pair<std::optional<Event>, std::string> next(Milliseconds within) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, within,
                      [&] { return !events_.empty() || !trouble_.empty(); });
    if (events_.empty())
      return {std::nullopt, trouble_};
    auto event = std::move(events_.front());
    events_.pop_front();
    return {std::move(event), ""};
  }

private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Event> events_;
  std::string trouble_;
};

// The rate of 16 bit audio of one channel, or 0.
int rate_of(const Event& event) {
  const auto rate = number_of(event.data, "rate", 0);
  const bool fits = number_of(event.data, "width", 2) == 2 &&
                    number_of(event.data, "channels", 1) == 1 &&
                    rate >= 4'000 && rate <= 384'000;
  return fits ? static_cast<int>(rate) : 0;
}

// One piece: sound as it comes, and words where they can be expected.
class Reception {
public:
  Reception(const tts::Words& words, tts::SpeechSink& sink)
      : words_(words), sink_(sink) {}

  // Returns whether more is expected.
  Expected<bool> take(const Event& event) {
    if (event.type == "audio-stop")
      return false;
    if (event.type == "error")
      return fail(ErrorKind::network, "the server reports an error: " +
                                          text_of(event.data, "text"));
    if (event.type != "audio-chunk")
      return true;
    const auto rate = rate_of(event);
    if (rate == 0 || (rate_ != 0 && rate != rate_))
      return fail(ErrorKind::network,
                  "the server's audio is not 16 bit of one channel");
    rate_ = rate;
    const auto samples = samples_of(event.payload);
    count_ += samples.size();
    if (duration(count_, rate) > longest_piece)
      return fail(ErrorKind::network, "the server does not stop talking");
    tell_words(duration(count_, rate));
    return sink_.sound(samples, rate);
  }

private:
  void tell_words(std::int64_t until) {
    for (; next_ < words_.size() && position_ <= until; ++next_) {
      sink_.word(next_, position_);
      position_ +=
          character_time *
          static_cast<std::int64_t>(tts::count_characters(words_[next_]) + 1);
    }
  }

  const tts::Words& words_;
  tts::SpeechSink& sink_;
  int rate_ = 0;
  std::size_t count_ = 0;
  std::size_t next_ = 0;
  std::int64_t position_ = 0;
};

class RemoteSynthesizer : public tts::Synthesizer {
public:
  RemoteSynthesizer(Client& client, std::string language)
      : client_(client), language_(std::move(language)) {}

  tts::PieceLength piece_length() const override {
    return {.wanted = 60, .longest = 400};
  }

  // The server knows its voices.
  Expected<void> check_voice(const std::string& voice) override {
    if (voice.size() > 200)
      return fail(ErrorKind::settings, "no voice has so long a name");
    return {};
  }

  Expected<void> speak(const tts::Words& words, bool,
                       const tts::VoiceSettings& settings,
                       tts::SpeechSink& sink) override {
    const auto answers = std::make_shared<Answers>();
    const auto connection = std::make_shared<std::unique_ptr<Connection>>();
    client_.post([this, answers, connection, event = order(words, settings)] {
      *connection = std::make_unique<Connection>(
          client_.route(),
          ConnectionCalls{
              [answers](Event one) { answers->put(std::move(one)); },
              [answers](const std::string& reason) { answers->end(reason); }});
      (*connection)->send(event);
    });
    auto outcome = receive(*answers, words, sink);
    client_.post([connection] { connection->reset(); });
    return outcome;
  }

private:
  Event order(const tts::Words& words,
              const tts::VoiceSettings& settings) const {
    Event event{"synthesize", {{"text", tts::joined(words)}}};
    if (!settings.voice.empty())
      event.data["voice"]["name"] = settings.voice;
    if (!language_.empty())
      event.data["voice"]["language"] = language_;
    return event;
  }

  // The connection ends by itself if it cannot be opened in time.
  Expected<void> receive(Answers& answers, const tts::Words& words,
                         tts::SpeechSink& sink) const {
    Reception reception(words, sink);
    auto silent = Milliseconds(0);
    const auto patience =
        client_.answer_timeout() + client_.route().connect_timeout;
    while (sink.is_wanted()) {
      const auto [event, trouble] = answers.next(look_up);
      silent = event ? Milliseconds(0) : silent + look_up;
      if (!trouble.empty() || silent > patience)
        return fail(
            ErrorKind::network,
            "the Wyoming server does not speak: " +
                (trouble.empty() ? "it does not answer in time" : trouble));
      if (!event)
        continue;
      const auto more = reception.take(*event);
      if (!more)
        return tl::make_unexpected(more.error());
      if (!*more)
        break;
    }
    return {};
  }

  Client& client_;
  const std::string language_;
};

} // namespace

Expected<std::unique_ptr<tts::Synthesizer>>
make_remote_synthesizer(Client& client, const std::string& language) {
  return std::make_unique<RemoteSynthesizer>(client, language);
}

} // namespace parlour::adapters::wyoming
