#include "adapters/wyoming/wyoming_wake.hpp"

#include <map>
#include <utility>

#include "adapters/wyoming/audio_events.hpp"
#include "adapters/wyoming/client.hpp"
#include "runtime/base/text/comma_list.hpp"
#include "runtime/plugin/open_messages.hpp"

namespace parlour::adapters {

namespace {

using Steady = std::chrono::steady_clock;
using Keywords = std::vector<std::string>;

// Each is a connection that never ends.
constexpr std::size_t max_streams = 64; // of as many sessions
constexpr std::size_t max_keywords = 100;
// A session that says nothing for so long may have ended.
constexpr Milliseconds idle_time{30'000};

const std::vector<OptionDescription>& descriptions() {
  static const auto all = [] {
    auto options = wyoming::client_options("10400");
    options.push_back(
        {"keywords", "", "names separated by commas; else all that it knows"});
    return options;
  }();
  return all;
}

} // namespace

// What the sessions send now, on the client's loop.
//
// A stream that has failed is opened again by the session's next audio, once
// the server is there and the pause is over.
//
//   Process   connects: detect, audio-start, audio-chunk
//   Process   audio-chunk ...               <- detection: Keyword
class WyomingWake::Streams {
public:
  Streams(WyomingWake& plugin, std::unique_ptr<wyoming::Client> client,
          Keywords keywords)
      : plugin_(plugin), client_(std::move(client)),
        keywords_(std::move(keywords)) {}
  Streams(const Streams&) = delete;
  Streams& operator=(const Streams&) = delete;
  ~Streams() {
    client_->end([this] { streams_.clear(); });
  }

  // Thread-safe.
  void hear(const Message& message, std::string samples,
            std::optional<std::int64_t> position) {
    const auto size = samples.size();
    client_->post(
        message.session,
        [this, message, samples = std::move(samples), position] {
          heard(message, samples, position);
        },
        size,
        [this, session = message.session] {
          closed(session, "it takes too little of what is sent");
        });
  }
  // The protocol cannot change the words of a connection: all begin anew.
  void look_for(Keywords keywords) {
    client_->post([this, keywords = std::move(keywords)] {
      keywords_ = keywords;
      streams_.clear();
      is_full_ = false;
    });
  }

private:
  struct Stream {
    Message order;                                   // the last message
    std::unique_ptr<wyoming::Connection> connection; // null: it has failed
    std::int64_t position = 0;                       // ms
    Steady::time_point next_attempt{};
    Steady::time_point heard_at{};
    // When it was told that no word is found.
    std::optional<Steady::time_point> told_at;
  };

  // Positions go on where no connection is there: the session's time does.
  void heard(const Message& message, const std::string& samples,
             std::optional<std::int64_t> position) {
    const auto found = streams_.find(message.session);
    if (found == streams_.end() && streams_.size() >= max_streams)
      forget_idle();
    if (found == streams_.end() && streams_.size() >= max_streams) {
      if (!std::exchange(is_full_, true))
        plugin_.answer(message, "Failed",
                       {"no words are found: too many sessions listen"});
      return;
    }
    auto& stream = streams_[message.session];
    stream.order = message;
    stream.heard_at = Steady::now();
    stream.position = position.value_or(stream.position);
    if (!stream.connection && client_->is_up() &&
        Steady::now() >= stream.next_attempt)
      open(stream, message.session);
    const auto event = wyoming::audio_chunk(samples, stream.position);
    stream.position += wyoming::duration_of(samples);
    if (stream.connection)
      stream.connection->send(event);
  }

  // Streams without a connection go as well: they find nothing now.
  void forget_idle() {
    const auto latest = Steady::now() - idle_time;
    const auto gone = std::erase_if(streams_, [&](const auto& one) {
      return !one.second.connection || one.second.heard_at < latest;
    });
    if (gone > 0)
      is_full_ = false;
  }

  // The next attempt is not before the pause is over, also if this one fails at
  // once.
  void open(Stream& stream, const SessionId& session) {
    stream.next_attempt = Steady::now() + client_->pause();
    wyoming::Event detect{"detect"};
    if (!keywords_.empty())
      detect.data["names"] = keywords_;
    stream.connection = client_->connect(session, calls_, detect);
  }

  // Tells that no word is found now, once a minute at most: it is tried again.
  void closed(const SessionId& session, const std::string& reason) {
    const auto found = streams_.find(session);
    if (found == streams_.end())
      return;
    auto& stream = found->second;
    stream.connection.reset();
    const auto now = Steady::now();
    if (stream.told_at && now - *stream.told_at < std::chrono::minutes(1))
      return;
    stream.told_at = now;
    plugin_.answer(stream.order, "Failed",
                   {"no words are found: the server: " + reason});
  }

  // A server that tells no time means the audio that it has just heard.
  void received(const SessionId& session, const wyoming::Event& event) {
    const auto& stream = streams_.at(session);
    if (event.type == "error")
      return closed(session, "it reports an error: " +
                                 wyoming::text_of(event.data, "text"));
    if (event.type != "detection")
      return;
    plugin_.answer(
        stream.order, "Keyword",
        {wyoming::text_of(event.data, "name"), Value(),
         wyoming::number_of(event.data, "timestamp", stream.position)});
  }

  WyomingWake& plugin_;
  const wyoming::SessionCalls calls_{
      [this](const SessionId& session, const wyoming::Event& event) {
        received(session, event);
      },
      [this](const SessionId& session, const std::string& reason) {
        closed(session, reason);
      }};
  const std::unique_ptr<wyoming::Client> client_;
  Keywords keywords_;
  std::map<SessionId, Stream> streams_;
  bool is_full_ = false; // that has been told
};

WyomingWake::WyomingWake() : RolePlugin("KeywordSpotter") {
  on("Process", &WyomingWake::on_process);
  on("SetKeywords", &WyomingWake::on_set_keywords);
}

WyomingWake::~WyomingWake() = default;

Expected<void> WyomingWake::on_start(const Options& options) {
  auto client = wyoming::Client::start(host(), options, descriptions(), "wake");
  if (!client)
    return tl::make_unexpected(client.error());
  streams_ = std::make_unique<Streams>(
      *this, std::move(*client),
      split_at_commas(option_value(options, descriptions(), "keywords")));
  return {};
}

void WyomingWake::stop() {
  streams_.reset();
}

void WyomingWake::on_process(const Binary& audio,
                             std::optional<std::int64_t> position) {
  const auto samples = speech_samples(audio);
  if (!samples)
    return refuse(samples.error().message);
  if (audio.bytes.size() > wyoming::longest_audio)
    return refuse("so much audio comes in several messages");
  auto order = without_its_way(current());
  order.params.clear(); // the samples travel by themselves
  streams_->hear(order, wyoming::bytes_of(*samples), position);
}

void WyomingWake::on_set_keywords(const List& words) {
  if (words.size() > max_keywords)
    return refuse("at most " + std::to_string(max_keywords) +
                  " keywords are looked for");
  Keywords keywords;
  for (const auto& word : words)
    keywords.push_back(word.text());
  streams_->look_for(std::move(keywords));
}

PluginFactory wyoming_wake_factory() {
  PluginDescription description;
  description.name = "WyomingWake";
  description.roles = {"KeywordSpotter"};
  description.sentence = "has wake words found by a server of the Wyoming "
                         "protocol: openWakeWord";
  description.options = descriptions();
  return {description, [] { return std::make_unique<WyomingWake>(); }};
}

} // namespace parlour::adapters
