// A plug-in (role Robot) that ends its process when it is told to go somewhere.
#include <cstdlib>

#include "runtime/plugin/adaptors.hpp"
#include "runtime/plugin/export.hpp"

namespace {

const std::vector<parlour::OptionDescription> options = {
    {"way",
     "abort",
     "how it ends its process",
     false,
     parlour::OptionType::choice,
     {"abort", "exit"}}};

class Abrupt : public parlour::RolePlugin {
public:
  Abrupt() : RolePlugin("Robot") {
    on("Goto", &Abrupt::on_goto);
  }

private:
  parlour::Expected<void> on_start(const parlour::Options& given) override {
    exits_ = option_value(given, options, "way") == "exit";
    return {};
  }
  void on_goto(const std::string&) {
    exits_ ? std::_Exit(0) : std::abort();
  }

  bool exits_ = false;
};

} // namespace

PARLOUR_PLUGIN(Abrupt, {.name = "Abrupt",
                        .roles = {"Robot"},
                        .sentence = "ends where it is to begin",
                        .options = options})
