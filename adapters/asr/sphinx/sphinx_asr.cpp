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
#include "runtime/plugin/adaptors.hpp"

namespace parlour::adapters {

namespace {

constexpr std::size_t partial_samples = speech_rate / 5;
constexpr std::size_t most_waiting = std::size_t{speech_rate} * 30;
constexpr std::size_t most_sessions = 1'000;
// An utterance without audio for so long may lose its recogniser.
constexpr Milliseconds left_alone(10'000);

const std::vector<OptionDescription>& option_descriptions() {
  static const std::vector<OptionDescription> descriptions = [] {
    auto all = asr::language_options();
    all.push_back({"least-agreement", "0.4",
                   "what is less certain is rejected, 0 to 1", false,
                   OptionType::number});
    all.push_back({"recognisers", "2",
                   "how many may speak at the same time, 1 to 16", false,
                   OptionType::integer});
    return all;
  }();
  return descriptions;
}

std::string option(const Options& options, const char* name) {
  return option_value(options, option_descriptions(), name);
}

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
    most_recognisers_ = static_cast<std::size_t>(count);
    model_ = option(options, "model");
    const auto sources = asr::language_sources(host(), options);
    if (!sources)
      return tl::make_unexpected(sources.error());
    auto vocabulary = asr::make_vocabulary(*sources, model_);
    if (!vocabulary)
      return tl::make_unexpected(vocabulary.error());
    vocabulary_ = std::make_shared<asr::Vocabulary>(std::move(*vocabulary));
    if (vocabulary_->language->sentences().arc_count() == 0) {
      host().log("The application has no grammars, values or examples, so "
                 "nothing can be heard.");
      most_recognisers_ = 0;
      return {};
    }
    auto first = asr::Hearing::make(vocabulary_, model_);
    if (!first)
      return tl::make_unexpected(first.error());
    free_.push_back(std::move(*first));
    made_ = 1;
    return {};
  }

  void stop() override {
    utterances_.clear();
    free_.clear();
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
    if (found == utterances_.end() || most_recognisers_ == 0) {
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
    tell(found->second.hearing->finish());
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

private:
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
    if (free_.empty() && made_ < most_recognisers_)
      if (auto made = asr::Hearing::make(vocabulary_, model_)) {
        free_.push_back(std::move(*made));
        ++made_;
      }
    if (free_.empty())
      take_back();
    if (free_.empty() || utterance.hearing)
      return;
    auto hearing = std::move(free_.back());
    free_.pop_back();
    const auto wanted = grammars_.find(session);
    if (auto begun =
            hearing.begin(wanted == grammars_.end() ? std::vector<std::string>()
                                                    : wanted->second);
        !begun)
      host().failed(begun.error().message);
    utterance.hearing.emplace(std::move(hearing));
  }

  // Ends an utterance that nobody goes on with: its session may be gone.
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
    fire_partial(written(asr::split_text(text)), ++utterance.revision,
                 utterance.hearing->ends(text));
    utterance.partial = std::move(text);
  }

  void tell(const asr::Heard& heard) {
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
      word.set("word", vocabulary_->language->written(each.word));
      word.set("begin", each.begin);
      word.set("end", each.end);
      word.set("agreed", static_cast<bool>(heard.agreed[i]));
      words.push_back(std::move(word));
    }
    List alternatives;
    for (const auto* other : {&heard.by_grammar, &heard.by_domain})
      alternatives.push_back(written(asr::split_text(*other)));
    fire_result(written(text), heard.agreement, std::move(alternatives),
                std::move(words));
  }

  std::string written(const std::vector<std::string>& words) const {
    std::vector<std::string> spelt;
    for (const auto& word : words)
      spelt.push_back(vocabulary_->language->written(word));
    return asr::text_of(spelt);
  }

  // Ends the session's utterance and gives its recogniser to one that waits.
  void end(const SessionId& session) {
    const auto found = utterances_.find(session);
    if (found == utterances_.end())
      return;
    if (found->second.hearing) {
      found->second.hearing->drop();
      free_.push_back(std::move(*found->second.hearing));
    }
    utterances_.erase(found);
    const auto next = std::ranges::find_if(
        utterances_, [](const auto& each) { return !each.second.hearing; });
    if (next != utterances_.end() && !free_.empty())
      catch_up(next->first, next->second);
  }

  void catch_up(const SessionId& session, Utterance& utterance) {
    give_recogniser(session, utterance);
    if (!utterance.hearing)
      return;
    utterance.hearing->hear(std::exchange(utterance.waiting, {}));
    const auto finish = std::move(utterance.finish);
    if (finish)
      as_answer_to(*finish, [this] { on_finish(); });
  }

  std::shared_ptr<const asr::Vocabulary> vocabulary_;
  std::string model_;
  double least_agreement_ = 0;
  std::size_t most_recognisers_ = 0;
  std::size_t made_ = 0;
  std::vector<asr::Hearing> free_;
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
