// Bell: a world with a bell whose event "Rings" runs the given statements, and
// a telephone exchange.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/script/dialogue/conversation_world.hpp"

namespace parlour::dialogue {

struct Bell : World {
  explicit Bell(const std::string& statements, const std::string& more = "",
                const WorldOptions& options = {})
      : World("<handler name='H'><messages><component><Bell><Rings>" +
                  statements +
                  "</Rings></Bell></component></messages></handler>" + more,
              options) {
    components["Bell"] = {};
    components["Exchange"] = {"Telephone"};
    said();
  }
  void ring(std::vector<Value> params = {}) {
    event("Bell", "Rings", std::move(params));
  }
};

} // namespace parlour::dialogue
