// World is the surroundings of one conversation (tools/world) while a corpus is
// played: a database that finds one row and accepts or refuses what is written.
// There are no components, files or sockets.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tools/world/surroundings.hpp"

namespace parlour::tools::corpus {

// Owned by the player, one for each dialogue. Not thread-safe.
class World : public Surroundings {
public:
  World(std::shared_ptr<const script::Program> its_program,
        std::shared_ptr<const PhraseEvaluator> phrases);

  // Begins the conversation and runs it until it is quiet.
  void open();
  // Says one utterance, then runs until nothing happens by itself. False if
  // that does not end.
  bool say(List acts);
  // The value of a slot in the conversation's frame.
  Value slot(const std::string& topic, const std::string& name) const {
    return conversation->slot_value(topic, name);
  }

  // Whether the database accepts what is written.
  bool writes_succeed = true;
  // All outputs so far.
  std::vector<dialogue::Output> said;
  // Errors of scripts.
  std::vector<std::string> errors;

private:
  Expected<ResultSet> answer(const dialogue::QueryRequest& request) const;
};

} // namespace parlour::tools::corpus
