#include "script/run/phrase_evaluator.hpp"

#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "runtime/base/random.hpp"
#include "script/program/computing_host.hpp"
#include "script/run/interpreter_pool.hpp"

namespace parlour::script {

namespace {

// The host of a phrase: it has the time of the utterance and random numbers.
class PhraseHost : public ComputingHost {
public:
  explicit PhraseHost(const Value& say)
      : ComputingHost("a phrase", say["now"].integer_or(0)),
        random_(static_cast<std::uint64_t>(say["rotation"].integer_or(0))) {}

  // From the rotation, so that equal inputs give equal words.
  double random() override {
    return random_.fraction();
  }

private:
  Random random_;
};

// What a phrase is chosen by.
struct Wanted {
  std::string topic;
  std::string slot;
};

class Evaluator : public PhraseEvaluator {
public:
  explicit Evaluator(std::shared_ptr<const Program> program)
      : pool_(std::move(program)) {
    for (const auto& phrase : pool_.program().phrases)
      by_act_[phrase.act].push_back(&phrase);
  }

  // A phrase that fails leaves its turn to the next one (language rule 12.7).
  Rendering render(const Value& say) const override {
    Rendering rendering;
    const auto phrases = by_act_.find(say["act"].text());
    if (phrases == by_act_.end())
      return rendering;
    const Wanted wanted{name_in(say, "topic"), name_in(say, "slot")};
    const auto turn = static_cast<std::uint64_t>(say["rotation"].integer_or(0));
    // From the most specific rank down, until a phrase gives words.
    for (int of_rank = max_specific; of_rank > 0; --of_rank) {
      const auto found =
          that_hold(phrases->second, wanted, of_rank, say, rendering);
      for (std::size_t i = 0; i < found.size() && !rendering.words; ++i) {
        const auto& phrase = *found[(turn + i) % found.size()];
        if (auto text = computed(phrase.text, say, rendering))
          rendering.words = text->text();
      }
      if (rendering.words)
        break;
    }
    return rendering;
  }

private:
  using Phrases = std::vector<const Phrase*>;

  static constexpr int max_specific = 16;

  // Empty if there is none.
  static std::string name_in(const Value& say, const char* key) {
    const auto& name = say[key];
    return name.is_unknown() ? std::string() : name.text();
  }

  // How specific a phrase is; 0 if it does not apply. A topic counts most, then
  // a slot, then belonging to the application, then having a condition.
  static int rank(const Phrase& phrase, const Wanted& wanted) {
    if ((!phrase.topic.empty() && phrase.topic != wanted.topic) ||
        (!phrase.slot.empty() && phrase.slot != wanted.slot))
      return 0;
    return 1 + (phrase.condition != no_code) + 2 * !phrase.of_platform +
           4 * (2 * !phrase.topic.empty() + !phrase.slot.empty());
  }

  // The phrases of one rank whose conditions hold.
  Phrases that_hold(const Phrases& phrases, const Wanted& wanted, int of_rank,
                    const Value& say, Rendering& rendering) const {
    Phrases found;
    for (const auto* phrase : phrases) {
      if (rank(*phrase, wanted) != of_rank)
        continue;
      if (phrase->condition == no_code ||
          computed(phrase->condition, say, rendering).value_or(false))
        found.push_back(phrase);
    }
    return found;
  }

  // Computes code of a phrase; errors are collected in `rendering`.
  std::optional<Value> computed(CodeId code, const Value& say,
                                Rendering& rendering) const {
    PhraseHost host(say);
    auto value = pool_.evaluate(
        code, {say["act"], say["topic"], say["slot"], say["data"]}, {}, host);
    if (value)
      return std::move(*value);
    rendering.failures.push_back(std::move(value.error()));
    return std::nullopt;
  }

  InterpreterPool pool_;
  // An act has few of all phrases.
  std::unordered_map<std::string, Phrases> by_act_;
};

} // namespace

std::shared_ptr<const PhraseEvaluator>
make_phrase_evaluator(std::shared_ptr<const Program> program) {
  return std::make_shared<Evaluator>(std::move(program));
}

} // namespace parlour::script
