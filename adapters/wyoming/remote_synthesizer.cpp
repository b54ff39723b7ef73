#include "adapters/wyoming/remote_synthesizer.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>

#include "adapters/wyoming/audio_events.hpp"

namespace parlour::adapters::wyoming {

namespace {

using Steady = std::chrono::steady_clock;

// How long after Stop the engine may still wait for the server.
constexpr Milliseconds look_up{50};
// About 15 characters a second; a wrong value moves the words' places, and
// nothing else.
constexpr std::int64_t character_time = 65; // ms, of usual speech

// What may wait for the engine, in bytes; the server waits with the rest.
constexpr std::size_t max_waiting = 1 << 20;

// What matters of an event.
struct Answer {
  enum class Kind : std::uint8_t { sound, end, error };
  Kind kind = Kind::sound;
  std::string bytes; // samples, or the error's text
  int rate = 0;      // of 16 bit audio of one channel; 0: it is something else
};

// What a server leaves out counts as the usual: 16 bits, one channel.
int rate_of(const Event& event) {
  const auto rate = number_of(event.data, "rate", 0);
  const bool fits = number_of(event.data, "width", 2) == 2 &&
                    number_of(event.data, "channels", 1) == 1 &&
                    rate >= 4'000 && rate <= 384'000;
  return fits ? static_cast<int>(rate) : 0;
}

// How much sound the words may be, in ms, however long the server talks.
// A bound for a broken server, far above any voice: ten words may take some 25
// s.
std::int64_t longest_sound(const tts::Words& words) {
  constexpr std::int64_t margin = 10'000;
  constexpr std::int64_t slowest = 4; // times as slow as usual
  const auto characters = tts::count_characters(tts::joined(words));
  return margin +
         slowest * character_time * static_cast<std::int64_t>(characters);
}

// Other events, such as audio-start, say nothing that matters here.
std::optional<Answer> answer_of(Event event) {
  using Kind = Answer::Kind;
  if (event.type == "audio-stop")
    return Answer{Kind::end, {}, 0};
  if (event.type == "error")
    return Answer{Kind::error, text_of(event.data, "text"), 0};
  if (event.type == "audio-chunk")
    return Answer{Kind::sound, std::move(event.payload), rate_of(event)};
  return std::nullopt;
}

// Between the loop, which receives, and the engine, which waits.
//
// It has a bound: when the engine is behind, the connection reads no further
// until half of it is used up.
class Answers {
public:
  // Whether the next one is to wait until `wanted` is called.
  // The answer is taken in any case: the bound may be exceeded by one.
  bool put(Answer answer, std::function<void()> wanted) {
    const std::lock_guard lock(mutex_);
    waiting_ += size_of(answer);
    answers_.push_back(std::move(answer));
    changed_.notify_all();
    if (waiting_ <= max_waiting)
      return false;
    wanted_ = std::move(wanted);
    return true;
  }
  void end(const std::string& reason) {
    const std::lock_guard lock(mutex_);
    trouble_ = reason;
    changed_.notify_all();
  }
  // The next one; the reason if there will be none; neither if none comes
  // within the time.
  std::pair<std::optional<Answer>, std::string> next(Milliseconds within) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, within,
                      [&] { return !answers_.empty() || !trouble_.empty(); });
    if (answers_.empty())
      return {std::nullopt, trouble_};
    auto answer = std::move(answers_.front());
    answers_.pop_front();
    waiting_ -= size_of(answer);
    if (waiting_ <= max_waiting / 2)
      if (const auto wanted = std::exchange(wanted_, nullptr))
        wanted();
    return {std::move(answer), ""};
  }

private:
  static std::size_t size_of(const Answer& answer) {
    return sizeof answer + answer.bytes.size();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Answer> answers_;
  std::size_t waiting_ = 0; // bytes
  std::function<void()> wanted_;
  std::string trouble_;
};

// One piece: sound as it comes, and words where they can be expected.
// The protocol tells no marks, so that a word's place is guessed by the
// characters before it. A word is told when the sound has reached it.
class Reception {
public:
  Reception(const tts::Words& words, tts::SpeechSink& sink)
      : words_(words), sink_(sink), longest_(longest_sound(words)) {}

  // Returns whether more is expected.
  Expected<bool> take(const Answer& answer) {
    if (answer.kind == Answer::Kind::end)
      return false;
    if (answer.kind == Answer::Kind::error)
      return fail(ErrorKind::network,
                  "the server reports an error: " + answer.bytes);
    if (answer.rate == 0 || (rate_ != 0 && answer.rate != rate_))
      return fail(ErrorKind::network,
                  "the server's audio is not 16 bit of one channel");
    rate_ = answer.rate;
    const auto samples = samples_of(answer.bytes);
    count_ += samples.size();
    if (duration(count_, rate_) > longest_)
      return fail(ErrorKind::network, "the server does not stop talking");
    tell_words(duration(count_, rate_));
    return sink_.sound(samples, rate_);
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
  const std::int64_t longest_; // ms
  int rate_ = 0;
  std::size_t count_ = 0;
  std::size_t next_ = 0;
  std::int64_t position_ = 0;
};

// One piece of text is one connection: synthesize, then the server's
// audio-start, audio-chunk and so on until audio-stop.
//
//   loop's thread:   Connection -> received() -> Answers
//   engine's thread:                             Answers -> Reception -> sink
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

  // The engine's thread waits here until the piece is over, or nobody wants it
  // any more. The connection is made and ended on the loop's thread.
  Expected<void> speak(const tts::Words& words, bool,
                       const tts::VoiceSettings& settings,
                       tts::SpeechSink& sink) override {
    const auto answers = std::make_shared<Answers>();
    const auto place = std::make_shared<Place>();
    client_.post([this, answers, place, event = order(words, settings)] {
      place->connection = std::make_unique<Connection>(
          client_.route(),
          ConnectionCalls{
              [this, answers, weak = std::weak_ptr(place)](Event one) {
                received(*answers, weak, std::move(one));
              },
              [answers](const std::string& reason) { answers->end(reason); }});
      place->connection->send(event);
    });
    auto outcome = receive(*answers, words, sink);
    client_.post([place] { place->connection.reset(); });
    return outcome;
  }

private:
  // Used on the loop's thread.
  struct Place {
    std::unique_ptr<Connection> connection; // null: it has ended
  };

  // Called by the connection itself: a weak pointer, as the place may have
  // gone, and so that the two do not keep each other.
  void received(Answers& answers, const std::weak_ptr<Place>& weak,
                Event event) const {
    auto answer = answer_of(std::move(event));
    const auto place = weak.lock();
    if (!answer || !place || !place->connection)
      return;
    auto go_on = [this, weak] {
      client_.post([weak] {
        if (const auto held = weak.lock(); held && held->connection)
          held->connection->resume();
      });
    };
    if (answers.put(std::move(*answer), go_on))
      place->connection->pause();
  }

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
  //
  // Looks up every 50 ms, so that Stop is noticed while the server is silent.
  Expected<void> receive(Answers& answers, const tts::Words& words,
                         tts::SpeechSink& sink) const {
    Reception reception(words, sink);
    const auto patience =
        client_.answer_timeout() + client_.route().connect_timeout;
    const auto latest =
        Steady::now() + patience + Milliseconds(longest_sound(words));
    auto heard = Steady::now();
    while (sink.is_wanted()) {
      const auto [answer, trouble] = answers.next(look_up);
      const auto now = Steady::now();
      if (answer)
        heard = now;
      if (!trouble.empty() || now > std::min(heard + patience, latest))
        return fail(
            ErrorKind::network,
            "the Wyoming server does not speak: " +
                (trouble.empty() ? "it does not answer in time" : trouble));
      if (!answer)
        continue;
      const auto more = reception.take(*answer);
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
