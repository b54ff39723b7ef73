// A robot that takes its process with it when it is to go somewhere.
#include <cstdlib>

#include "runtime/plugin/adaptors.hpp"
#include "runtime/plugin/export.hpp"

namespace {

class Abrupt : public parlour::RolePlugin {
public:
  Abrupt() : RolePlugin("Robot") {
    on("Goto", &Abrupt::on_goto);
  }

private:
  void on_goto(const std::string&) {
    std::abort();
  }
};

} // namespace

PARLOUR_PLUGIN(Abrupt, {.name = "Abrupt",
                        .roles = {"Robot"},
                        .sentence = "ends where it is to begin"})
