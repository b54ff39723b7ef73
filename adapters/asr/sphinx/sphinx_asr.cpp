// Decoding takes about a tenth of the time of what is decoded, so it is done in
// the component's own thread, frame by frame as they come: when the utterance
// ends, all but the last frame is decoded. In virtual time nothing needs to be
// waited for.
#include "adapters/asr/sphinx/sphinx_asr.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "adapters/asr/sphinx/hearing.hpp"
#include "adapters/asr/sphinx/language_sources.hpp"
#include "adapters/asr/sphinx/recogniser_pool.hpp"
#include "runtime/plugin/adaptors.hpp"

namespace parlour::adapters {

namespace {

// 200 ms: to ask the decoder for its text takes time, too.
constexpr std::size_t partial_samples = speech_rate / 5;
// 30 s; who speaks longer while all are busy is not heard to the end.
constexpr std::size_t most_waiting = std::size_t{speech_rate} * 30;
constexpr std::size_t most_sessions = 1'000;
// An utterance without audio for so long may lose its recogniser.
constexpr Milliseconds left_alone(10'000);

const std::vector<OptionDescription>& option_descriptions() {
  static const std::vector<OptionDescription> descriptions = [] {
    std::vector<OptionDescription> all{
        {"model", "/usr/share/pocketsphinx/model/en-us",
         "folder of the acoustic model and its dictionary"}};
    const auto& language = asr::language_options();
    all.insert(all.end(), language.begin(), language.end());
    all.push_back({"least-agreement", "0.5",
                   "what is less certain is rejected, 0 to 1", false,
                   OptionType::number});
    all.push_back({"recognisers", "2",
                   "how many may speak at the same time, 1 to 16", false,
                   OptionType::integer});
    all.push_back({"one-by-one", "false",
                   "uses new values before the next message; virtual time "
                   "sets it",
                   false, OptionType::boolean});
    return all;
  }();
  return descriptions;
}

std::string option(const Options& options, const char* name) {
  return option_value(options, option_descriptions(), name);
}

// A session without a recogniser collects its audio; when one is free, it is
// decoded at once, faster than it was spoken.
//
// The way of an utterance:
//
//   first audio      a recogniser is taken, or the audio waits
//   further audio    decoded as it comes; Partial every 200 ms of audio
//   Finish           RecognitionResult or Rejected; the recogniser goes back
//   nothing for 10 s another session may take the recogniser
class SphinxASR : public ASRPlugin {
protected:
  Expected<void> on_start(const Options& options) override {
    if (auto built = asr::SphinxDecoder::is_built_in(); !built)
      return built;
    least_agreement_ =
        parse_number(option(options, "least-agreement")).number_or(-1);
    if (least_agreement_ < 0 || least_agreement_ > 1)
      return fail(ErrorKind::settings,
                  "the option 'least-agreement' is 0 to 1");
    const auto count =
        parse_number(option(options, "recognisers")).integer_or(0);
    if (count < 1 || count > 16)
      return fail(ErrorKind::settings, "the option 'recognisers' is 1 to 16");
    one_by_one_ = option(options, "one-by-one") == "true";
    auto sources = asr::language_sources(host(), options);
    if (!sources)
      return tl::make_unexpected(sources.error());
    auto pool =
        asr::RecogniserPool::make(std::move(*sources), option(options, "model"),
                                  static_cast<std::size_t>(count));
    if (!pool)
      return tl::make_unexpected(pool.error());
    pool_ = std::move(*pool);
    tell_limits();
    return {};
  }

  void stop() override {
    loop_.reset(); // it may be making a vocabulary
    utterances_.clear();
    pool_.reset();
  }

  void on_do_recognition(const Binary& audio) override {
    const Value value(audio);
    const auto samples = speech_samples(value);
    if (!samples)
      return refuse(samples.error().message);
    if (utterances_.size() >= most_sessions)
      take_back();
    auto& utterance = utterances_[current().session];
    if (utterance.finish)
      return; // the utterance before still waits to be heard
    utterance.used = host().clock().now();
    if (!utterance.hearing)
      give_recogniser(current().session, utterance);
    if (utterance.hearing)
      return hear(utterance, *samples);
    auto& waiting = utterance.waiting;
    const auto room = most_waiting - std::min(most_waiting, waiting.size());
    const auto taken = samples->first(std::min(room, samples->size()));
    waiting.insert(waiting.end(), taken.begin(), taken.end());
  }

  // An utterance that still waits for a recogniser is decoded when there is
  // one.
  void on_finish() override {
    const auto found = utterances_.find(current().session);
    if (found == utterances_.end() || pool_->is_deaf()) {
      utterances_.erase(current().session);
      return fire_rejected("nothing was said that can be heard");
    }
    if (found->second.finish)
      return fire_rejected("the utterance before is not recognised yet");
    if (!found->second.hearing) {
      found->second.finish = std::make_unique<Message>(current());
      host().after(left_alone, [this] { take_back(); });
      return;
    }
    auto& hearing = *found->second.hearing;
    tell(hearing.finish(), hearing.vocabulary()->made->language);
    end(current().session);
  }

  void on_cancel() override {
    end(current().session);
  }

  void on_set_grammar(const List& names) override {
    if (grammars_.size() >= most_sessions)
      grammars_.clear();
    auto& wanted = grammars_[current().session];
    wanted.clear();
    for (const auto& name : names)
      wanted.push_back(name.text());
    std::ranges::sort(wanted);
    if (wanted.empty())
      grammars_.erase(current().session);
  }

  // Several columns of a table are told one after the other.
  void on_set_values(const std::string& column, const List& values) override {
    if (pool_->set_values(column, values) && !std::exchange(is_stale_, true))
      host().after(Milliseconds::zero(), [this] { renew(); });
  }

private:
  // Either `hearing` is there, or `waiting` has the audio so far.
  struct Utterance {
    std::optional<asr::Hearing> hearing;
    std::vector<Sample> waiting;     // for a recogniser
    std::unique_ptr<Message> finish; // that waits, too
    Timestamp used = 0;              // when audio came last
    std::size_t since_partial = 0;
    std::string partial;
    std::int64_t revision = 0;
  };

  // Leaves the utterance without one if all are busy.
  void give_recogniser(const SessionId& session, Utterance& utterance) {
    if (!give_free(session, utterance)) {
      take_back();
      if (!utterance.hearing) // it may have got the one that was taken back
        give_free(session, utterance);
    }
  }

  // With the grammars that the session wants now.
  bool give_free(const SessionId& session, Utterance& utterance) {
    auto hearing = pool_->take();
    if (!hearing)
      return false;
    const auto wanted = grammars_.find(session);
    if (auto begun = hearing->begin(wanted == grammars_.end()
                                        ? std::vector<std::string>()
                                        : wanted->second);
        !begun)
      host().failed(begun.error().message);
    utterance.hearing = std::move(hearing);
    return true;
  }

  // Ends an utterance that nobody goes on with: its session may be gone.
  // At most one: the caller needs one.
  void take_back() {
    const auto before = host().clock().now() - left_alone.count();
    const auto found = std::ranges::find_if(utterances_, [&](const auto& each) {
      return each.second.hearing && each.second.used <= before;
    });
    if (found != utterances_.end())
      end(SessionId(found->first));
  }

  void hear(Utterance& utterance, std::span<const Sample> samples) {
    utterance.hearing->hear(samples);
    utterance.since_partial += samples.size();
    if (utterance.since_partial < partial_samples)
      return;
    utterance.since_partial = 0;
    auto text = utterance.hearing->partial();
    if (text.empty() || text == utterance.partial)
      return;
    const auto& language = utterance.hearing->vocabulary()->made->language;
    fire_partial(written(asr::split_text(text), language), ++utterance.revision,
                 utterance.hearing->ends(text));
    utterance.partial = std::move(text);
  }

  // Two texts that do not agree are worse than none: the user is asked again.
  void tell(const asr::Heard& heard, const asr::Language& language) {
    if (heard.words.empty())
      return fire_rejected("nothing was understood");
    if (heard.agreement < least_agreement_)
      return fire_rejected("it sounded like \"" + heard.by_grammar +
                           "\" or like \"" + heard.by_domain + "\"");
    List words;
    std::vector<std::string> text;
    for (std::size_t i = 0; i < heard.words.size(); ++i) {
      const auto& each = heard.words[i];
      text.push_back(each.word);
      Map word;
      word.set("word", language.written(each.word));
      word.set("begin", each.begin);
      word.set("end", each.end);
      word.set("agreed", static_cast<bool>(heard.agreed[i]));
      words.push_back(std::move(word));
    }
    List alternatives;
    for (const auto* other : {&heard.by_grammar, &heard.by_domain})
      alternatives.push_back(written(asr::split_text(*other), language));
    fire_result(written(text, language), heard.agreement,
                std::move(alternatives), std::move(words));
  }

  static std::string written(const std::vector<std::string>& words,
                             const asr::Language& language) {
    std::vector<std::string> spelt;
    for (const auto& word : words)
      spelt.push_back(language.written(word));
    return asr::text_of(spelt);
  }

  // Ends the session's utterance and gives its recogniser to one that waits.
  void end(const SessionId& session) {
    const auto found = utterances_.find(session);
    if (found == utterances_.end())
      return;
    if (found->second.hearing) {
      found->second.hearing->drop();
      pool_->give_back(std::move(*found->second.hearing));
    }
    utterances_.erase(found);
    serve_waiting();
  }

  // Those that wait for a recogniser get one, as long as there is one.
  void serve_waiting() {
    for (;;) {
      const auto next = std::ranges::find_if(
          utterances_, [](const auto& each) { return !each.second.hearing; });
      if (next == utterances_.end() || !give_free(next->first, next->second))
        return;
      catch_up(next->second);
    }
  }

  // A Finish that waited is answered as if it came now.
  void catch_up(Utterance& utterance) {
    utterance.hearing->hear(std::exchange(utterance.waiting, {}));
    const auto finish = std::move(utterance.finish);
    if (finish)
      as_answer_to(*finish, [this] { on_finish(); });
  }

  // -- new values -------------------------------------------------------------

  // Nobody who speaks waits for it.
  void renew() {
    is_stale_ = false;
    if (one_by_one_)
      return use(pool_->renew());
    if (!loop_) {
      auto loop =
          Loop::start([this](const std::string& what) { host().log(what); });
      if (!loop)
        return host().log("The new values are not heard: " +
                          loop.error().message);
      loop_ = std::move(*loop);
    }
    pool_->renew(*loop_, [this](const asr::RecogniserPool::Outcome& outcome) {
      host().after(Milliseconds::zero(), [this, outcome] { use(outcome); });
    });
  }

  // On the plug-in's own thread, between two messages.
  void use(const asr::RecogniserPool::Outcome& outcome) {
    if (!*outcome)
      return host().log("The new values are not heard: " +
                        outcome->error().message);
    pool_->use(std::move(**outcome));
    tell_limits();
    serve_waiting(); // what is new is free
  }

  void tell_limits() {
    if (pool_->is_deaf())
      host().log("The application has no grammars, values or examples, so "
                 "nothing can be heard.");
    else if (!pool_->is_whole())
      host().log("The application's grammars and values are more than the "
                 "grammar of the recogniser can hold: some sentences are heard "
                 "by its domain model alone. Fewer values in one sentence, or "
                 "grammars for states and slots, help.");
  }

  double least_agreement_ = 0;
  bool one_by_one_ = false;
  std::unique_ptr<asr::RecogniserPool> pool_;
  bool is_stale_ = false; // values have changed, and nothing is made of it yet
  std::unique_ptr<Loop> loop_;
  std::map<SessionId, Utterance> utterances_;
  std::map<SessionId, std::vector<std::string>> grammars_;
};

} // namespace

PluginFactory sphinx_asr_factory() {
  PluginDescription description;
  description.name = "SphinxASR";
  description.roles = {"ASR"};
  description.sentence =
      "hears what the application expects, by PocketSphinx; English";
  description.options = option_descriptions();
  description.events = {{"Failed", "reason", Reply::refusal}};
  return {std::move(description), [] { return std::make_unique<SphinxASR>(); }};
}

} // namespace parlour::adapters
