#include "adapters/asr/sphinx/sphinx_keywords.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "adapters/asr/sphinx/keyword_search.hpp"
#include "runtime/base/text/comma_list.hpp"
#include "runtime/plugin/role_plugin.hpp"

namespace parlour::adapters {

namespace {

// All phrases are one search.
constexpr std::size_t max_phrases = 50;
// A session that says nothing for so long may have ended: its search may serve
// another one. A search that changed hands with each frame would find nothing.
constexpr Milliseconds idle_time{5'000};

const std::vector<OptionDescription> options = {
    {"keywords", "", "the phrases, separated by commas"},
    {"sensitivity", "0.5", "0: finds only what is clear, to 1: finds too much",
     false, OptionType::number},
    {"streams", "4", "how many sessions it hears at the same time, 1 to 16",
     false, OptionType::integer},
    {"model", "/usr/share/pocketsphinx/model/en-us",
     "folder of the acoustic model and its dictionary"}};

// Everything runs on the plug-in's thread. `spare_` is a search that nobody has
// yet.
class SphinxKeywords : public RolePlugin {
public:
  SphinxKeywords() : RolePlugin("KeywordSpotter") {
    on("Process", &SphinxKeywords::on_process);
    on("SetKeywords", &SphinxKeywords::on_set_keywords);
  }

  void stop() override {
    streams_.clear();
  }

protected:
  Expected<void> on_start(const Options& given) override {
    if (auto built = asr::SphinxDecoder::is_built_in(); !built)
      return built;
    sensitivity_ =
        parse_number(option_value(given, options, "sensitivity")).number_or(-1);
    if (sensitivity_ < 0 || sensitivity_ > 1)
      return fail(ErrorKind::settings, "the option 'sensitivity' is 0 to 1");
    const auto count =
        parse_number(option_value(given, options, "streams")).integer_or(0);
    if (count < 1 || count > 16)
      return fail(ErrorKind::settings, "the option 'streams' is 1 to 16");
    max_streams_ = static_cast<std::size_t>(count);
    model_ = option_value(given, options, "model");
    return look_for(split_at_commas(option_value(given, options, "keywords")));
  }

private:
  struct Stream {
    std::unique_ptr<asr::KeywordSearch> search;
    std::int64_t position = 0; // ms, where its audio ends
    Timestamp used = 0;
  };

  // All sessions begin anew: a search cannot change its phrases.
  Expected<void> look_for(const std::vector<std::string>& phrases) {
    const auto application = host().understanding();
    auto made = asr::make_keywords(
        phrases, model_, sensitivity_,
        application ? asr::given_sounds(application->pronunciations)
                    : asr::Pronunciations());
    if (!made)
      return tl::make_unexpected(made.error());
    keywords_ = std::make_shared<asr::Keywords>(std::move(*made));
    streams_.clear();
    is_full_ = false;
    spare_.reset();
    return prepare();
  }

  // So that no error comes later, and the first to speak need not wait.
  Expected<void> prepare() {
    if (keywords_->phrases.empty() || spare_)
      return {};
    auto made = asr::KeywordSearch::make(keywords_, model_);
    if (!made)
      return tl::make_unexpected(made.error());
    spare_ = std::make_unique<asr::KeywordSearch>(std::move(*made));
    return {};
  }

  void on_set_keywords(const List& list) {
    if (list.size() > max_phrases)
      return refuse("at most " + std::to_string(max_phrases) +
                    " phrases are looked for");
    std::vector<std::string> phrases;
    for (const auto& phrase : list)
      phrases.push_back(phrase.text());
    if (const auto done = look_for(phrases); !done)
      refuse(done.error().message);
  }

  // A gap in the positions means that audio is missing: what was heard before
  // it does not go on.
  void on_process(const Binary& audio, std::optional<std::int64_t> position) {
    const Value value(audio);
    const auto samples = speech_samples(value);
    if (!samples)
      return refuse(samples.error().message);
    if (keywords_->phrases.empty())
      return;
    if (!has_place(current().session))
      return tell_full();
    auto& stream = stream_of(current().session);
    if (!stream.search)
      return refuse("there is no memory for another search");
    // Positions may be rounded.
    if (position && std::abs(*position - stream.position) > frame_time) {
      stream.search->begin();
      stream.position = *position;
    }
    stream.position += duration(samples->size());
    for (const auto& found : stream.search->hear(*samples))
      fire_event("Keyword", {found.phrase, found.confidence, stream.position});
  }

  bool has_place(const SessionId& session) {
    return streams_.contains(session) || streams_.size() < max_streams_ ||
           drop_idle();
  }

  // Not for each frame.
  void tell_full() {
    if (!std::exchange(is_full_, true))
      refuse("no words are found: more sessions listen than the option "
             "'streams' allows (" +
             std::to_string(max_streams_) + ")");
  }

  // Without a search where none could be made.
  Stream& stream_of(const SessionId& session) {
    auto& stream = streams_[session];
    stream.used = host().clock().now();
    if (!stream.search && prepare())
      stream.search = std::move(spare_);
    return stream;
  }

  // The search of the session that was heard longest ago serves another one.
  // False: all are heard.
  bool drop_idle() {
    const auto found = std::ranges::min_element(
        streams_, {}, [](const auto& each) { return each.second.used; });
    if (host().clock().now() - found->second.used < idle_time.count())
      return false;
    spare_ = std::move(found->second.search);
    if (spare_)
      spare_->begin();
    streams_.erase(found);
    is_full_ = false;
    return true;
  }

  std::string model_;
  double sensitivity_ = 0;
  std::size_t max_streams_ = 0;
  std::shared_ptr<const asr::Keywords> keywords_;
  std::unique_ptr<asr::KeywordSearch> spare_;
  std::map<SessionId, Stream> streams_;
  bool is_full_ = false; // that has been told
};

} // namespace

PluginFactory sphinx_keywords_factory() {
  PluginDescription description;
  description.name = "SphinxKeywords";
  description.roles = {"KeywordSpotter"};
  description.sentence = "finds phrases in speech, by PocketSphinx; English";
  description.options = options;
  description.events = {{"Failed", "reason", Reply::refusal}};
  return {std::move(description),
          [] { return std::make_unique<SphinxKeywords>(); }};
}

} // namespace parlour::adapters
