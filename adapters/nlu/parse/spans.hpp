// Where in an utterance a value stands, for each entity that grammars ask for.
#pragma once

#include <vector>

#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/values/schema.hpp"

namespace parlour::adapters::nlu {

struct Span {
  EntityId entity = words_entity;
  std::uint32_t begin = 0; // tokens, with titles and determiners before it
  std::uint32_t end = 0;
  std::uint32_t core = 0;            // where the value itself begins
  Value value;                       // of a normal form
  std::vector<std::uint32_t> values; // of a set, equally good ones
  float confidence = 1;
  bool weak = false;      // only where such a value is expected
  bool unmatched = false; // words where a value of the set was expected
  float gain = 0;         // for the score
  float covered = 0;      // for the share of the utterance understood
};

class Spans {
public:
  // `entities` are the ones that the grammars mention, sorted.
  Spans(const Schema& schema, const Utterance& utterance,
        const std::vector<EntityId>& entities, Now now);

  // Indices of the known values of this entity that begin here.
  std::vector<std::uint32_t> at(EntityId entity, std::size_t position) const;

  // The same for open words, up to `most` of them. For a set (`entity`) they
  // are words for which it has no value; none where it has one. For a normal
  // form they are numbers that are none of it: "25:00".
  std::vector<std::uint32_t> open(EntityId entity, std::size_t position,
                                  std::size_t most);

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
  bool is_known(std::size_t position) const;
  bool inside_name(std::size_t position) const;
  bool value_near(EntityId entity, std::size_t first, std::size_t last) const;
  bool can_stand(std::size_t position) const;
  std::vector<std::uint32_t> open_number(EntityId entity, std::size_t position,
                                         std::size_t most);
  float open_gain(std::size_t position) const;

  struct Opened {
    EntityId entity;
    std::size_t position;
    std::size_t most;
    std::vector<std::uint32_t> spans;
  };

  const Schema& schema_;
  const Utterance& utterance_;
  std::vector<Span> spans_;
  std::vector<bool> plain_; // the utterance's, and what a normal form takes
  std::vector<std::vector<std::uint32_t>> by_begin_;
  std::vector<Opened> opened_; // what open() has made
};

} // namespace parlour::adapters::nlu
