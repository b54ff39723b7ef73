// Finds the places in an utterance where a value stands, for each entity that
// the grammars mention.
#pragma once

#include <span>
#include <vector>

#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/values/schema.hpp"

namespace parlour::adapters::nlu {

// From this confidence on the words are the value's own; below the other one,
// they only sound or look like it.
inline constexpr float certain_value = 0.95F;
inline constexpr float guessed_value = 0.9F;

// A value at a place of the utterance.
struct Span {
  EntityId entity = words_entity;
  // Tokens, including titles and determiners before the value.
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  // The token at which the value itself begins.
  std::uint32_t core = 0;
  // Of a normal form.
  Value value;
  // Of a set: the values that fit equally well.
  std::vector<std::uint32_t> values;
  float confidence = 1;
  // Counts only where a value of this entity is expected.
  bool weak = false;
  // Words in the place of a value, of which the set has none.
  bool unmatched = false;
  // Added to the score of a match.
  float gain = 0;
  // Added to the share of the utterance that is understood.
  float covered = 0;
};

// Built for one utterance. Refers to schema and utterance, which must outlive
// it. Spans are addressed by index, since open() adds to the list.
class Spans {
public:
  // `entities` are those that the grammars mention, sorted.
  Spans(const Schema& schema, const Utterance& utterance,
        const std::vector<EntityId>& entities, Now now);

  // Indices of spans, valid as long as this.
  using Indices = std::span<const std::uint32_t>;

  // The spans of known values of this entity that begin at `position`.
  Indices at(EntityId entity, std::size_t position) const;

  // The spans of words that are no known value, one for each length up to
  // `most` words. For any words (words_entity) they are the value. For a set
  // they are an unknown value; no span begins at or inside a known value.
  // For a normal form they are numbers that are not of this form: "25:00" for a
  // time.
  Indices open(EntityId entity, std::size_t position, std::size_t most);

  // The words from `position` on, whatever they mean: up to each word of the
  // clause, but no more than a sentence has.
  Indices rest(std::size_t position);
  const Span& operator[](std::uint32_t index) const {
    return spans_[index];
  }
  const std::vector<Span>& all() const {
    return spans_;
  }

private:
  void add_forms(const std::vector<EntityId>& entities, Now now);
  void add_values(const std::vector<EntityId>& entities);
  void add(Span span);
  void mark_plain(const Span& span);
  // Whether a value of any set begins here and is clearly meant.
  bool is_known(std::size_t position) const;
  bool inside_name(std::size_t position) const;
  bool value_near(EntityId entity, std::size_t first, std::size_t last) const;
  bool can_stand(std::size_t position) const;
  std::vector<std::uint32_t> make_open(EntityId entity, std::size_t position,
                                       std::size_t most);
  std::vector<std::uint32_t> open_words(EntityId entity, std::size_t position,
                                        std::size_t most);
  std::vector<std::uint32_t> open_number(EntityId entity, std::size_t position,
                                         std::size_t most);
  std::vector<std::uint32_t> rest_of_clause(std::size_t position);
  float open_gain(std::size_t position) const;

  // What open() has returned, for the next call with the same arguments.
  struct Opened {
    EntityId entity;
    std::size_t most;
    std::vector<std::uint32_t> spans;
  };

  const Schema& schema_;
  const Utterance& utterance_;
  std::vector<Span> spans_;
  // Utterance::plain, and the tokens of normal forms.
  std::vector<bool> plain_;
  // By position, sorted by entity.
  std::vector<std::vector<std::uint32_t>> by_begin_;
  std::vector<std::vector<Opened>> opened_; // by position
};

} // namespace parlour::adapters::nlu
