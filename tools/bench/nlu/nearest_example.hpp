// What two dozen lines of code reach: a text is about the topic of the example
// with which it shares most words.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "runtime/message/understanding.hpp"

namespace parlour::tools {

class NearestExample {
public:
  explicit NearestExample(const UnderstandingModel& model);

  // Empty if no example has any of its words.
  std::string topic(const std::string& text) const;

private:
  struct Example {
    std::string topic;
    std::size_t words = 0;
  };

  std::vector<Example> examples_;
  // By word: the examples that have it.
  std::unordered_map<std::string, std::vector<std::size_t>> having_;
};

} // namespace parlour::tools
