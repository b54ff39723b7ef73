#include "adapters/nlu/acts/other_terms.hpp"

#include <algorithm>

#include "adapters/nlu/forms/normal_forms.hpp"
#include "adapters/nlu/parse/question_words.hpp"
#include "adapters/nlu/text/word_set.hpp"

namespace parlour::adapters::nlu {

namespace {

// So many words of a sentence come before what it says of a time or condition;
// "if it is free" begins with it.
constexpr std::uint32_t words_before = 2;

class Terms {
public:
  Terms(const Utterance& utterance, const std::vector<BuiltAct>& acts,
        const BuiltAct& yes, const Context& context)
      : utterance_(utterance), acts_(acts), yes_(yes), context_(context),
        question_(utterance, context),
        sentence_(stretch_of(utterance.tokens, {yes.begin, yes.end},
                             Break::sentence)) {}

  std::optional<TokenRange> find() const {
    for (auto at = yes_.end; at < sentence_.end; ++at) {
      if (const auto length = length_at(at); length > 0) {
        const TokenRange words{at, at + length};
        return is_asked(words) || is_said_of_something(at)
                   ? std::nullopt
                   : std::optional(words);
      }
      if (!leads_there(at))
        return {};
    }
    return {};
  }

private:
  const std::string& word(std::uint32_t at) const {
    return utterance_.tokens.list[at].word;
  }

  // "yes, but only for the other one"; not "yes, it is half past nine".
  bool leads_there(std::uint32_t at) const {
    static const WordSet words{"in", "at",   "on",  "for",  "by",   "the",
                               "to", "then", "but", "only", "with", "from",
                               "ok", "just", "and", "maybe"};
    return utterance_.filler[at] || words.contains(word(at));
  }

  // Of a time, or of a condition to the end of its sentence; 0: none begins
  // here.
  std::uint32_t length_at(std::uint32_t at) const {
    static const WordSet conditions{"if",      "unless", "once",     "after",
                                    "before",  "until",  "till",     "other",
                                    "another", "wrong",  "different"};
    return conditions.contains(word(at)) ? sentence_.end - at
                                         : length_of_time(at);
  }

  std::uint32_t length_of_time(std::uint32_t at) const {
    static const WordSet presently{"now", "today", "again"};
    static const WordSet in_the_end{"later", "afterwards", "sometime"};
    if (in_the_end.contains(word(at)))
      return 1;
    if (utterance_.filler[at] || presently.contains(word(at)))
      return 0;
    std::size_t longest = 0;
    for (const auto form : {Form::date, Form::time, Form::duration})
      if (const auto found = form_at(form, utterance_.tokens, at, context_.now);
          found && !found->weak)
        longest = std::max(longest, found->length);
    return static_cast<std::uint32_t>(longest);
  }

  bool is_asked(TokenRange words) const {
    for (auto at = words.begin; at < words.end; ++at)
      if (!question_.has(at))
        return false;
    return true;
  }

  // "Yes, at six", of the taxi that is spoken of. "Yes, and is there breakfast
  // before six?" is a sentence of its own.
  bool is_said_of_something(std::uint32_t at) const {
    return std::ranges::any_of(acts_, [&](const BuiltAct& act) {
      return act.topic != no_topic && act.begin <= at && at < act.end &&
             (context_.goes_on(act.topic) ||
              (!act.elliptical && at >= act.begin + words_before));
    });
  }

  const Utterance& utterance_;
  const std::vector<BuiltAct>& acts_;
  const BuiltAct& yes_;
  const Context& context_;
  const QuestionWords question_;
  const TokenRange sentence_;
};

} // namespace

std::optional<TokenRange> other_terms(const Utterance& utterance,
                                      const std::vector<BuiltAct>& acts,
                                      const BuiltAct& yes,
                                      const Context& context) {
  if (context.confirms.empty())
    return {};
  return Terms(utterance, acts, yes, context).find();
}

} // namespace parlour::adapters::nlu
